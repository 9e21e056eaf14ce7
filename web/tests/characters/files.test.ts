import assert from "node:assert/strict";
import { test } from "node:test";
import { findCharacters, findObstacle, readJson } from "../../src/characters/files";
import { partName, Parts } from "../../src/characters/parts";
import { makeSample, toGlb } from "./sample";

const named = (...names: string[]) => names.map(name => ({ name }));
const partsOf = (...names: string[]) => new Parts({ name: "x" }, named(...names), file => file.name);
const encode = (text: string) => new TextEncoder().encode(text).buffer as ArrayBuffer;

test("a character is found among the files that were dropped with it", () => {
  assert.deepEqual(findCharacters(named("walk.bvh")), []);
  const [found, ...others] = findCharacters(named("Skin.PNG", "Hero.GLTF", "hero.bin"));
  assert.equal(found.main.name, "Hero.GLTF");
  assert.deepEqual(["skin.png", "textures/hero.bin", "hair.png"].map(address => found.parts.find(address)?.name), ["Skin.PNG", "hero.bin", undefined]);
  assert.deepEqual(others, []);
});

test("several characters can be dropped together", () => {
  assert.deepEqual(findCharacters(named("a.vrm", "walk.bvh", "b.glb")).map(each => each.main.name), ["a.vrm", "b.glb"]);
});

test("of parts with the same name, each character gets the one in its own folders", () => {
  const paths = ["hero/a.gltf", "hero/hair/colour.png", "hero/skin/colour.png", "villain/b.gltf", "villain/skin/colour.png", "villain/scene.bin", "hero/scene.bin"];
  const files = paths.map(path => ({ path, name: path.slice(path.lastIndexOf("/") + 1) }));
  const [hero, villain] = findCharacters(files, file => file.path);
  const found = (who: typeof hero, ...addresses: string[]) => addresses.map(address => who.parts.find(address)?.path);
  assert.deepEqual(found(hero, "scene.bin", "./skin/colour.png", "Hair\\Colour.png"), ["hero/scene.bin", "hero/skin/colour.png", "hero/hair/colour.png"]);
  assert.deepEqual(found(villain, "scene.bin", "skin/colour.png", "../hero/hair/colour.png"), ["villain/scene.bin", "villain/skin/colour.png", "hero/hair/colour.png"]);
  assert.deepEqual(found(hero, "C:/models/hero/hair/colour.png"), ["hero/hair/colour.png"]);
});

test("of folders with the same names, the one that was dropped with the character gives its parts", () => {
  const find = (main: string, address: string, ...paths: string[]) => new Parts(main, paths, path => path).find(address);
  assert.equal(find("hero.gltf", "colour.png", "2k/colour.png", "colour.png", "4k/colour.png"), "colour.png");
  assert.equal(find("hero/hero.gltf", "colour.png", "backup/hero/colour.png", "hero/colour.png", "old/hero/colour.png"), "hero/colour.png");
  assert.equal(find("hero.gltf", "skin/colour.png", "2k/skin/colour.png", "colour.png"), "2k/skin/colour.png");
});

test("a percent sign in a folder or a name changes nothing else", () => {
  const find = (address: string) => new Parts("hero.gltf", ["50% grey/skin a.png", "100%.png"], path => path).find(address);
  assert.equal(find("50% grey/skin%20a.png"), "50% grey/skin a.png");
  assert.equal(find("50%25%20grey%2FSkin%20a.png"), "50% grey/skin a.png");
  assert.equal(find("50% grey/../100%.png"), "100%.png");
});

test("addresses in a file lead to the dropped files", () => {
  assert.equal(partName("textures/Skin%20a.png?x#y"), "skin a.png");
  assert.equal(partName("..\\Tex\\A.png"), "a.png");
  assert.equal(partName("100%.png"), "100%.png");
});

test("what a file needs and is not there is said in one sentence", () => {
  const json = { buffers: [{ uri: "a.bin" }, { uri: "data:xyz" }, {}], images: ["b", "c", "d", "e"].map(name => ({ uri: `${name}.png` })) };
  assert.equal(findObstacle("x.gltf", json, partsOf()), "x.gltf needs a.bin, b.png, c.png and 2 more files. Drop all of its files together.");
  assert.equal(findObstacle("x.gltf", json, partsOf("a.bin", "b.png", "c.png", "d.png", "e.png")), null);
});

test("compressed files are refused in one sentence", () => {
  const json = { extensionsRequired: ["KHR_draco_mesh_compression", "KHR_texture_basisu", "KHR_materials_unlit"] };
  assert.equal(findObstacle("x.glb", json, partsOf()), "x.glb is compressed with Draco and textured with KTX2, which this page cannot read. Export it without.");
  assert.match(findObstacle("x.glb", { extensionsUsed: ["KHR_draco_mesh_compression"] }, partsOf())!, /Draco/);
  assert.equal(findObstacle("x.glb", { extensionsUsed: ["EXT_meshopt_compression"] }, partsOf()), null);
  assert.match(findObstacle("x.glb", { extensionsRequired: ["EXT_meshopt_compression"] }, partsOf())!, /meshopt/);
});

test("the JSON of both kinds of files is read", () => {
  const sample = makeSample({ vrm: "1" });
  const json = JSON.parse(JSON.stringify(sample.json)) as unknown;
  assert.deepEqual(readJson("a.vrm", toGlb(sample)), json);
  assert.deepEqual(readJson("a.gltf", encode(JSON.stringify(sample.json))), json);
});

test("other and damaged files are refused in one sentence", () => {
  assert.throws(() => readJson("a.glb", encode("")), /^Error: a\.glb is empty\.$/);
  for (const text of ["{", "null", "3", "{}", "not really a file of this kind"])
    assert.throws(() => readJson("a.glb", encode(text)), /^Error: a\.glb is not a glTF or VRM file\.$/);

  const picture = Uint8Array.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, ...Array(40).fill(7)]).buffer;
  assert.throws(() => readJson("a.vrm", picture), /^Error: a\.vrm is not a glTF or VRM file\.$/);
  const glb = toGlb(makeSample({ vrm: null }));
  assert.throws(() => readJson("a.glb", glb.slice(0, 200)), /damaged/);
  new DataView(glb).setUint32(4, 1, true);
  assert.throws(() => readJson("a.glb", glb), /old version/);
});
