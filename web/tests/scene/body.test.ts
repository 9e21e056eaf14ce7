import assert from "node:assert/strict";
import { test } from "node:test";
import { Matrix4, Object3D, Quaternion, Vector3 } from "three";
import { BoneCount, Pose } from "../../src/live/pose";
import { Body } from "../../src/scene/body";
import { performer } from "../performers";

function anyPose(): Pose {
  const pose = new Pose();
  pose.hips.set([0.4, 0.9, -1.2]);
  for (let bone = 0; bone < BoneCount; bone++) {
    const turn = new Quaternion(Math.sin(bone), Math.cos(3 * bone), Math.sin(2 * bone + 1), 1 + bone % 3).normalize();
    pose.rotations.set(turn.toArray(), bone * 4);
  }

  return pose;
}

test("joints are where three.js puts the nodes of the same pose", () => {
  const info = performer();
  const body = new Body(info);
  const pose = anyPose();
  const nodes = info.bones.map(() => new Object3D());
  info.bones.forEach((bone, i) => {
    nodes[i].position.set(...(i === 0 ? [...pose.hips] : bone.offset) as [number, number, number]);
    nodes[i].quaternion.fromArray(pose.rotations, i * 4);
    if (body.parents[i] >= 0)
      nodes[body.parents[i]].add(nodes[i]);
  });
  nodes[0].updateMatrixWorld(true);

  body.show(pose);

  nodes.forEach((node, i) => {
    const place = new Vector3().setFromMatrixPosition(node.matrixWorld);
    assert.ok(place.distanceTo(new Vector3().fromArray(body.positions, i * 3)) < 1e-5, `${info.bones[i].name} is elsewhere`);
    const turned = new Matrix4().makeRotationFromQuaternion(new Quaternion().fromArray(body.rotations, i * 4));
    for (let element = 0; element < 11; element++)
      assert.ok(Math.abs(turned.elements[element] - node.matrixWorld.elements[element]) < 1e-5 || element % 4 === 3);
  });
});

test("a pose is shown without a new array", () => {
  const body = new Body(performer());
  const { positions, rotations } = body;
  body.show(anyPose());
  body.show(anyPose());
  assert.equal(body.positions, positions);
  assert.equal(body.rotations, rotations);
});

test("bones have their index by name", () => {
  const body = new Body(performer());
  assert.equal(body.indexOf("Bone12"), 12);
  assert.equal(body.indexOf("Tail"), -1);
  assert.equal(body.parents[0], -1);
  assert.equal(body.parents[13], 9);
});
