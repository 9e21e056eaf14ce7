import assert from "node:assert/strict";
import { test } from "node:test";
import { findTakes } from "../../src/takes/files";

const found = (...names: string[]) => findTakes(names.map(name => ({ name }))).map(file => file.name);

test("takes are found beside characters and their parts", () => {
  assert.deepEqual(found("walk.bvh", "Hero.glb"), ["walk.bvh"]);
  assert.deepEqual(found("a.NMREC", "b.bvh"), ["a.NMREC", "b.bvh"]);
  assert.deepEqual(found("hero.gltf", "hero.bin", "skin.png"), []);
  assert.deepEqual(found("stream.bin"), ["stream.bin"]);
});

test("a single file of any name may be a take, unless it is a character", () => {
  assert.deepEqual(found("take"), ["take"]);
  for (const name of ["hero.vrm", "hero.glb", "hero.gltf", "hero.fbx"])
    assert.deepEqual(found(name), []);
});
