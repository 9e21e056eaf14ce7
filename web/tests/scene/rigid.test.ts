import assert from "node:assert/strict";
import { test } from "node:test";
import { Bone, BufferAttribute, BufferGeometry, Color, Group, type Mesh, MeshBasicMaterial, MeshLambertMaterial, MeshStandardMaterial, Skeleton, SkinnedMesh, Vector3 } from "three";
import { drawEverywhere } from "../../src/scene/bounds";
import { createSolid, withoutGloss } from "../../src/scene/materials";
import { makeRigid } from "../../src/scene/rigid";

test("rigid parts are where the skin was, in every pose", () => {
  const [root, hips, arm] = [new Group(), new Bone(), new Bone()];
  hips.position.set(0.1, 1, 0);
  hips.rotation.set(0.2, 0.4, 0);
  arm.position.set(0.3, 0.2, 0.1);
  hips.add(arm);
  root.add(hips);
  root.updateMatrixWorld(true);
  const places = [[0, 1, 0], [0.1, 1, 0], [0, 1.1, 0], [0.4, 1.2, 0.1], [0.5, 1.2, 0.1], [0.4, 1.3, 0.1]];
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(places.flat()), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(places.flatMap(() => [0, 0, 1])), 3));
  geometry.setAttribute("skinIndex", new BufferAttribute(new Uint8Array([0, 0, 0, 1, 1, 1].flatMap(bone => [bone, 0, 0, 0])), 4));
  geometry.setAttribute("skinWeight", new BufferAttribute(new Float32Array(places.flatMap(() => [1, 0, 0, 0])), 4));
  geometry.setIndex([0, 1, 2, 3, 4, 5]);
  const skin = new SkinnedMesh(geometry, new MeshStandardMaterial({ color: "teal" }));
  root.add(skin);
  skin.bind(new Skeleton([hips, arm]));

  hips.rotation.set(1, -0.5, 0.3);
  arm.rotation.set(0, 0, 1.2);
  root.updateMatrixWorld(true);
  const expected = places.map((place, i) => skin.localToWorld(skin.applyBoneTransform(i, new Vector3(...place))));
  makeRigid(skin);
  root.updateMatrixWorld(true);
  assert.equal(skin.parent, null);
  [hips, arm].forEach((bone, number) => {
    const part = bone.children.find(child => (child as Mesh).isMesh) as Mesh;
    assert.ok(part.material instanceof MeshLambertMaterial && part.material.color.equals(new Color("teal")));
    assert.equal(part.geometry.boundingSphere, geometry.boundingSphere);
    assert.deepEqual([...part.geometry.getIndex()!.array], [0, 1, 2].map(corner => corner + 3 * number));
    for (const corner of part.geometry.getIndex()!.array)
      assert.ok(part.localToWorld(new Vector3(...places[corner])).distanceTo(expected[corner]) < 1e-6);
  });
});

test("a processor that draws compiles no gloss", () => {
  assert.ok(createSolid(new Color("teal"), 0.5, true) instanceof MeshLambertMaterial);
  const solid = createSolid(new Color("teal"), 0.5, false);
  assert.ok(solid instanceof MeshStandardMaterial && solid.roughness === 0.5);
  const other = new MeshBasicMaterial();
  assert.equal(withoutGloss(other), other);
});

test("no picture measures a skin in its pose", () => {
  const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array([0, 0, 0, 0, 2, 0, 0, 1, 0]), 3));
  const skin = new SkinnedMesh(geometry, new MeshBasicMaterial());
  drawEverywhere(skin);
  assert.equal(skin.frustumCulled, false);
  assert.deepEqual(skin.boundingSphere?.center.toArray(), [0, 1, 0]);
});
