import assert from "node:assert/strict";
import { test } from "node:test";
import { type Mesh, type Object3D, type SkinnedMesh, Vector3 } from "three";
import { Character } from "../../src/characters/character";
import { loadCharacter, type LoadedCharacter } from "../../src/characters/load";
import { Parts } from "../../src/characters/parts";
import { describeSkeleton, type Skeleton } from "../../src/characters/skeleton";
import { makeSample, mixamoName, type SampleOptions, toGlb } from "./sample";

globalThis.self ??= globalThis as never;

const noParts = new Parts<File>(new File([], "x.gltf"), [], file => file.name);

async function load(options: SampleOptions): Promise<{ loaded: LoadedCharacter; skeleton: Skeleton }> {
  const main = new File([toGlb(makeSample(options))], "boxes.vrm");
  const loaded = await loadCharacter({ main, parts: noParts });
  return { loaded, skeleton: describeSkeleton(loaded) };
}

function near(actual: readonly number[], expected: readonly number[], what: string): void {
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-4, `${what}: ${actual} instead of ${expected}`));
}

/** Where the nodes of a description are, without turns and scales of their own. */
function placeOf(skeleton: Skeleton, index: number): Vector3 {
  return skeleton.objects[index].getWorldPosition(new Vector3());
}

test("the bones of a VRM are its normalized bones, and face forward", async () => {
  for (const vrm of ["0", "1"] as const) {
    const { loaded, skeleton } = await load({ vrm, twisted: true });
    assert.equal(loaded.vrm?.meta.metaVersion, vrm);
    for (const index of Object.values(skeleton.humanoid!))
      near(skeleton.nodes[index].rotation, [0, 0, 0, 1], skeleton.nodes[index].name);
    assert.ok(skeleton.nodes.every((node, i) => node.parent < i));
    near(placeOf(skeleton, skeleton.humanoid!["leftHand"]).toArray(), [0.66, 1.4, 0], `left hand of VRM ${vrm}`);
    near(placeOf(skeleton, skeleton.humanoid!["leftToes"]).toArray(), [0.09, 0.02, 0.13], `left toes of VRM ${vrm}`);
    near([skeleton.lowest!], [0], "lowest point");
  }
});

test("a VRM without a required bone says which", async () => {
  await assert.rejects(load({ vrm: "1", without: ["rightHand", "rightIndexProximal", "rightLittleProximal"] }), /^Error: boxes\.vrm lacks these bones: right hand\.$/);
});

test("a glTF file gives the joints of its skin with their names in the file", async () => {
  const { skeleton } = await load({ vrm: null, nameOf: mixamoName, scale: 0.01, twisted: true });
  assert.equal(skeleton.humanoid, undefined);
  const hips = skeleton.nodes.findIndex(node => node.name === "mixamorig:Hips");
  near(placeOf(skeleton, hips).toArray(), [0, 0.95, 0], "hips");
  near(skeleton.nodes[hips].translation, [0, 95, 0], "hips in the file");
  near([skeleton.lowest!], [0], "lowest point");
  assert.deepEqual(skeleton.nodes[skeleton.nodes[hips].parent].scale, [0.01, 0.01, 0.01]);
  assert.ok(!skeleton.nodes.some(node => node.name === "Body"));
});

test("a file with Z up in centimetres, a morph target and a second skin stands on the floor and is freed", async () => {
  const { loaded, skeleton } = await load({ vrm: null, nameOf: mixamoName, scale: 0.01, zUp: true, rich: true, twisted: true });
  const placed = (joint: string) => placeOf(skeleton, skeleton.nodes.findIndex(node => node.name === mixamoName(joint)));
  near(placed("hips").toArray(), [0, 0.95, 0], "hips");
  near(placed("leftHand").toArray(), [0.66, 1.4, 0], "left hand");
  near(placed("leftToes").toArray(), [0.09, 0.02, 0.13], "left toes");
  near([skeleton.lowest!], [0], "lowest point");
  let skins = 0;
  let morphs = 0;
  const freed = new Set<object>();
  loaded.root.traverse(object => {
    const mesh = object as SkinnedMesh;
    skins += mesh.isSkinnedMesh ? 1 : 0;
    morphs += Object.keys(mesh.geometry?.morphAttributes ?? {}).length;
    mesh.geometry?.addEventListener("dispose", () => freed.add(mesh.geometry));
  });
  assert.deepEqual([skins, morphs], [2, 1]);
  new Character(loaded, skeleton).dispose();
  assert.ok(freed.size > 0);
});

test("a vertex that follows a joint outside its skin is a damaged file, and no picture fails", async () => {
  const sample = makeSample({ vrm: null });
  const skins = sample.json["skins"] as { joints: number[]; inverseBindMatrices?: number }[];
  skins[0].joints.length = 3;
  const main = new File([toGlb(sample)], "broken.glb");
  await assert.rejects(loadCharacter({ main, parts: noParts }), /^Error: broken\.glb is damaged: a part of it follows a joint that its skin does not have\.$/);
});

test("a file that lacks its end says so, and no other fault shows words of the script engine", async () => {
  const glb = new Uint8Array(toGlb(makeSample({ vrm: "1" })));
  const cut = new File([glb.slice(0, glb.length - 500)], "cut.glb");
  await assert.rejects(loadCharacter({ main: cut, parts: noParts }), /^Error: cut\.glb is cut off: its end is missing\.$/);

  const sample = makeSample({ vrm: null });
  (sample.json["accessors"] as { count: number }[])[0].count = 1e9;
  const wrong = new File([toGlb(sample)], "wrong.glb");
  await assert.rejects(loadCharacter({ main: wrong, parts: noParts }), /^Error: wrong\.glb is damaged, and cannot be shown\. Export it again\.$/);
});

test("a joint without weight may be any number, as some programs write it", async () => {
  const sample = makeSample({ vrm: null });
  const { meshes, accessors, bufferViews } = sample.json as {
    meshes: { primitives: { attributes: { JOINTS_0: number } }[] }[];
    accessors: { bufferView: number; count: number }[];
    bufferViews: { byteOffset: number }[];
  };
  const { bufferView, count } = accessors[meshes[0].primitives[0].attributes.JOINTS_0];
  const joints = new Uint16Array(sample.binary, bufferViews[bufferView].byteOffset, count * 4);
  for (let vertex = 0; vertex < count; vertex++)
    joints[vertex * 4 + 3] = 0xffff;
  const main = new File([toGlb(sample)], "unused.glb");
  assert.equal((await loadCharacter({ main, parts: noParts })).name, "unused.glb");
});

test("nodes in the pose of an animation return to the pose of the skin", async () => {
  const { skeleton: expected } = await load({ vrm: null, nameOf: mixamoName, lowered: 40, twisted: true });
  const { skeleton } = await load({ vrm: null, nameOf: mixamoName, lowered: 40, twisted: true, posed: 70 });
  skeleton.nodes.forEach((node, i) => near(node.rotation, expected.nodes[i].rotation, node.name));
  near([skeleton.lowest!], [0], "lowest point");
});

test("poses turn the nodes, and a VRM's own bones follow", async () => {
  for (const options of [{ vrm: "1", twisted: true }, { vrm: "0", twisted: true }, { vrm: null }] as const) {
    const { loaded, skeleton } = await load(options);
    const character = new Character(loaded, skeleton);
    const indexOf = (name: string) => skeleton.humanoid?.[name] ?? skeleton.nodes.findIndex(node => node.name === name);
    character.bind({
      id: 7,
      bones: [{ node: indexOf("hips"), bone: "Hips", humanoid: "hips" }, { node: indexOf("leftUpperArm"), bone: "LeftArm", humanoid: "leftUpperArm" }, { node: indexOf("leftHand"), bone: "LeftHand", humanoid: "leftHand" }],
      hipsNode: indexOf("hips"),
      problems: [],
    });
    assert.equal(character.show(new DataView(new ArrayBuffer(10))), false);
    assert.equal(character.isShown, false);

    // The identity except for a quarter turn of the arm about Z, and the hips a metre up. Of VRM 0.x, the axes are turned.
    const quarter = options.vrm === "0" ? -Math.SQRT1_2 : Math.SQRT1_2;
    assert.ok(character.show(poseOf([0, 1.95, 0], [[0, 0, 0, 1], [0, 0, quarter, Math.SQRT1_2], [0, 0, 0, 1]])));
    assert.ok(character.update(16));
    character.group.updateMatrixWorld(true);
    near(character.joints()["Hips"], [0, 1.95, 0], `hips ${options.vrm}`);
    near(character.joints()["LeftHand"], [0.16, 1.4 + 1 + 0.5, 0], `hand ${options.vrm}`);
    character.place = 2;
    assert.equal(character.place, 2);
    character.accompany(0, 0, 0);
    assert.ok(Math.abs(character.joints()["Hips"][0] - 2.2) < 1e-4);
  }
});

test("hair does not fly to another moment or another place", async () => {
  const { loaded, skeleton } = await load({ vrm: "1" });
  const character = new Character(loaded, skeleton);
  const hips = skeleton.humanoid!["hips"];
  character.bind({ id: 7, bones: [{ node: hips, bone: "Hips", humanoid: "hips" }], hipsNode: hips, problems: [] });
  const [root, tip] = ["tail0", "tail2"].map(name => loaded.root.getObjectByName(name)!);
  const direction = (): Vector3 => tip.getWorldPosition(new Vector3()).sub(root.getWorldPosition(new Vector3())).normalize();
  const show = (x: number, time: number): void => {
    character.show(poseOf([x, 0.95, 0], [[0, 0, 0, 1]], time));
    character.update(16);
  };
  for (let time = 0; time < 1000; time += 16)
    show(0, time);

  const rest = direction();
  const turn = (): number => rest.angleTo(direction()) * 180 / Math.PI;
  show(0.1, 1016);
  assert.ok(turn() > 20, `a movement turns it by ${turn()}`);
  const changes: (() => void)[] = [() => show(3, 1032), () => show(3.4, 3000), () => show(3, 1000), () => {
    character.place = 3;
    show(3, 1016);
  }];
  changes.forEach((change, i) => {
    change();
    assert.ok(turn() < 20, `change ${i} turns it by ${turn()}`);
  });
});

test("all that a character holds on the graphics card is freed", async () => {
  const { loaded, skeleton } = await load({ vrm: "1" });
  const character = new Character(loaded, skeleton);
  const held = new Set<object>();
  let freed = 0;
  loaded.root.traverse((object: Object3D) => {
    const mesh = object as Mesh | SkinnedMesh;
    for (const each of mesh.isMesh ? [mesh.geometry, ...[mesh.material].flat()] : []) {
      if (held.has(each))
        continue;
      held.add(each);
      each.addEventListener("dispose", () => freed++);
    }
  });
  character.dispose();
  assert.ok(held.size >= 2);
  assert.equal(freed, held.size);
});

function poseOf(hips: readonly number[], rotations: readonly (readonly number[])[], time = 0): DataView {
  const view = new DataView(new ArrayBuffer(28 + rotations.length * 6));
  view.setUint8(0, 1);
  view.setUint8(1, 2);
  view.setUint16(2, rotations.length, true);
  view.setUint32(8, time * 1000, true);
  hips.forEach((value, i) => view.setFloat32(16 + i * 4, value, true));
  rotations.forEach((rotation, i) => {
    const largest = rotation.reduce((best, value, axis) => Math.abs(value) > Math.abs(rotation[best]) ? axis : best, 0);
    const sign = Math.sign(rotation[largest]);
    const words = rotation.filter((_, axis) => axis !== largest).map(value => Math.round(value * sign * 16383 * Math.SQRT2) + 16384);
    view.setUint16(28 + i * 6, words[0] | (largest & 1) << 15, true);
    view.setUint16(30 + i * 6, words[1] | (largest & 2) << 14, true);
    view.setUint16(32 + i * 6, words[2], true);
  });
  return view;
}
