import assert from "node:assert/strict";
import { test } from "node:test";
import { avatarOf, BoneCount, decodePose, Pose } from "../../src/live/pose";

const Size = 386;

function identityPose(name = ""): DataView {
  const bytes = new Uint8Array(Size + name.length);
  const view = new DataView(bytes.buffer);
  bytes.set([1, 1, name.length, 0]);
  view.setInt32(4, 3, true);
  view.setBigInt64(8, 1_760_000_000_123_456n, true);
  view.setUint32(16, 77, true);
  view.setFloat32(20, 12.5, true);
  view.setFloat32(24, 84, true);
  view.setFloat32(28, -250, true);
  for (let at = 32; at < Size; at += 6)
    bytes.set([0x00, 0xc0, 0x00, 0xc0, 0x00, 0x40], at);
  return view;
}

test("a pose has the values of its bytes, in metres and milliseconds", () => {
  const pose = new Pose();
  assert.ok(decodePose(identityPose("Ada"), pose));
  assert.equal(pose.avatar, 3);
  assert.equal(pose.time, 1_760_000_000_123.456);
  assert.equal(pose.frame, 77);
  assert.deepEqual([...pose.hips], [0.125, Math.fround(0.84), -2.5]);
  for (let bone = 0; bone < BoneCount; bone++)
    assert.deepEqual([...pose.rotations.subarray(bone * 4, bone * 4 + 4)], [0, 0, 0, 1]);
});

test("each component of a rotation can be the one left out", () => {
  const values = [0.1, -0.2, 0.3, Math.sqrt(1 - 0.14)];
  for (let leftOut = 0; leftOut < 4; leftOut++) {
    const expected = [...values.slice(0, 3)];
    expected.splice(leftOut, 0, values[3]);
    const words = expected.filter((_, i) => i !== leftOut).map(c => 16384 + Math.round(c * 16383 * Math.SQRT2));
    const view = identityPose();
    view.setUint16(32 + 60, words[0] | (leftOut & 1) << 15, true);
    view.setUint16(32 + 62, words[1] | leftOut >> 1 << 15, true);
    view.setUint16(32 + 64, words[2], true);
    const pose = new Pose();
    assert.ok(decodePose(view, pose));
    expected.forEach((value, i) => assert.ok(Math.abs(pose.rotations[40 + i] - value) < 1e-4));
  }
});

test("a time before 1970 and a missing frame number are read", () => {
  const view = identityPose();
  view.setBigInt64(8, -1_500n, true);
  view.setUint8(1, 0);
  const pose = new Pose();
  decodePose(view, pose);
  assert.equal(pose.time, -1.5);
  assert.equal(pose.frame, -1);
});

test("other bytes are no pose, and change nothing", () => {
  const pose = new Pose();
  const other = identityPose();
  other.setUint8(0, 2);
  const cut = new DataView(identityPose("Ada").buffer, 0, Size);
  for (const view of [other, cut, new DataView(new ArrayBuffer(0))]) {
    assert.equal(decodePose(view, pose), false);
    assert.equal(avatarOf(view), -1);
  }

  assert.equal(pose.avatar, -1);
});
