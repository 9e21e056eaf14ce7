import assert from "node:assert/strict";
import { test } from "node:test";
import { type InstancedMesh, Matrix4, type Mesh, Vector2, Vector3 } from "three";
import { BoneCount, Pose } from "../../src/live/pose";
import { JointAxes } from "../../src/scene/axes";
import { Body } from "../../src/scene/body";
import { ContactMarks } from "../../src/scene/contacts";
import { isSoftwareName } from "../../src/scene/graphics";
import { Quality } from "../../src/scene/quality";
import type { Stage } from "../../src/scene/stage";
import { Sticks } from "../../src/scene/sticks";
import { Trails } from "../../src/scene/trails";
import { performer } from "../performers";

function standing(): Body {
  const info = performer();
  const named: Record<number, string> = { 3: "RightFoot", 6: "LeftFoot", 12: "Head", 16: "RightHand", 39: "LeftHand" };
  const nameOf = (name: string): string => named[Number(name.slice(4))] ?? name;
  const bones = info.bones.map(bone => ({ ...bone, name: nameOf(bone.name), parent: bone.parent === null ? null : nameOf(bone.parent) }));
  const body = new Body({ ...info, bones });
  const pose = new Pose();
  pose.hips.set([0, 1, 0]);
  for (let bone = 0; bone < BoneCount; bone++)
    pose.rotations[bone * 4 + 3] = 1;
  body.show(pose);
  return body;
}

test("a stick reaches from the parent to the bone", () => {
  const body = standing();
  const sticks = new Sticks(body, "#4f8fdc", false);
  sticks.update();
  const matrix = new Matrix4();
  const mesh = sticks.group.children[0] as InstancedMesh;
  for (let bone = 1; bone < BoneCount; bone++) {
    mesh.getMatrixAt(bone - 1, matrix);
    const parent = new Vector3().fromArray(body.positions, body.parents[bone] * 3);
    const end = new Vector3().fromArray(body.positions, bone * 3);
    assert.ok(new Vector3(0, 0, 0).applyMatrix4(matrix).distanceTo(parent) < 1e-6);
    assert.ok(new Vector3(0, 1, 0).applyMatrix4(matrix).distanceTo(end) < 1e-6);
    assert.ok(matrix.determinant() > 0, "a stick is not turned inside out");
  }
});

test("axes start at the joints and have the joint's directions", () => {
  const body = standing();
  const axes = new JointAxes(body);
  axes.update();
  const points = axes.lines.geometry.getAttribute("position");
  const joint = new Vector3().fromArray(body.positions, 3);
  assert.ok(new Vector3().fromBufferAttribute(points, 6).distanceTo(joint) < 1e-6);
  const x = new Vector3().fromBufferAttribute(points, 7).sub(joint);
  assert.ok(x.x > 0.05 && Math.abs(x.y) < 1e-6 && Math.abs(x.z) < 1e-6);
});

test("trails join poses, and begin anew after a jump in time or place", () => {
  const body = standing();
  const trails = new Trails(body, "#4f8fdc", new Vector2(100, 100));
  const origin = new Vector3();
  const born = (trails.mesh as Mesh).geometry.getAttribute("born");
  const pieces = (): number => (born.array as Float32Array).filter(time => time > -1).length;
  trails.update(1000, origin);
  assert.equal(pieces(), 0);
  trails.update(1016, origin);
  trails.update(1033, origin);
  assert.equal(pieces(), 8);
  trails.update(1033, origin);
  assert.equal(pieces(), 8);

  for (let i = 0; i < body.positions.length; i += 3)
    body.positions[i] += 2;
  trails.update(1050, origin);
  assert.equal(pieces(), 8);
  trails.update(500, origin);
  assert.equal(pieces(), 0);
});

test("a contact appears under the foot, and fades when it ends", () => {
  const marks = new ContactMarks(standing(), "#4f8fdc");
  assert.equal(marks.update(16, true), false);
  marks.set(true, false);
  assert.equal(marks.update(16, true), true);
  assert.deepEqual(marks.meshes.map(mesh => mesh.visible), [true, false]);
  marks.set(false, false);
  marks.update(1000, true);
  assert.deepEqual(marks.meshes.map(mesh => mesh.visible), [false, false]);
  marks.set(true, true);
  marks.update(16, false);
  assert.deepEqual(marks.meshes.map(mesh => mesh.visible), [false, false]);
});

test("slow pictures lower the quality, single ones do not", () => {
  const { quality, changes } = qualityOf(false);
  for (let i = 0; i < 300; i++)
    quality.judge(i % 10 === 0 ? 250 : 16);
  assert.deepEqual(changes, []);
  for (let i = 0; i < 300; i++)
    quality.judge(100);
  assert.deepEqual(changes, [[1.25, 1024], [1, 512], [0.75, 512], [0.6, 0]]);
});

test("slow pictures count by their time, so that very slow graphics need few", () => {
  const { quality, changes } = qualityOf(false);
  for (let i = 0; i < 10; i++)
    quality.judge(250);
  assert.equal(changes.length, 1);
});

test("a processor that draws begins with the least quality", () => {
  assert.deepEqual(qualityOf(true).changes, [[0.6, 0]]);
  assert.ok(isSoftwareName("ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)"));
  assert.ok(isSoftwareName("llvmpipe (LLVM 15.0.6, 256 bits)"));
  assert.ok(isSoftwareName("ANGLE (Microsoft, Microsoft Basic Render Driver Direct3D11 vs_5_0 ps_5_0, D3D11)"));
  assert.ok(!isSoftwareName("ANGLE (Intel, Mesa Intel(R) UHD Graphics 620 (KBL GT2), OpenGL 4.6)"));
  assert.ok(!isSoftwareName("Apple GPU"));
});

function qualityOf(isSoftware: boolean): { quality: Quality; changes: [number, number][] } {
  const changes: [number, number][] = [];
  const setQuality = (pixels: number, shadows: number): void => {
    changes.push([pixels, shadows]);
  };
  return { quality: new Quality({ isSoftware, setQuality } as unknown as Stage), changes };
}

test("trails are where a performer stands on the stage, and stay there", () => {
  const body = standing();
  const trails = new Trails(body, "#4f8fdc", new Vector2(100, 100));
  const { geometry } = trails.mesh as Mesh;
  const [start, end] = ["start", "end"].map(name => geometry.getAttribute(name));
  const hand = body.positions[body.indexOf("LeftHand") * 3];
  trails.update(1000, new Vector3(5, 0, 0));
  trails.update(1016, new Vector3(5.1, 0, 0));
  trails.update(1033, new Vector3(5.3, 0, 0));
  const ends = [start.getX(0), end.getX(0), start.getX(4), end.getX(4)];
  ends.forEach((x, i) => assert.ok(Math.abs(x - hand - [5, 5.1, 5.1, 5.3][i]) < 1e-5, `${ends}`));
});
