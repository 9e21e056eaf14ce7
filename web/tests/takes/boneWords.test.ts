import assert from "node:assert/strict";
import { test } from "node:test";
import { wordsOf } from "../../src/takes/boneWords";

const Fingers = ["Index", "Middle", "Ring", "Pinky"].flatMap(finger => [`InHand${finger}`, ...[1, 2, 3].map(part => `Hand${finger}${part}`)]);
const Limbs = ["UpLeg", "Leg", "Foot", "Shoulder", "Arm", "ForeArm", "Hand", "HandThumb1", "HandThumb2", "HandThumb3", ...Fingers];
const Trunks = {
  Neck1: ["Hips", "Spine", "Spine1", "Spine2", "Neck", "Neck1", "Head"],
  Spine3: ["Hips", "Spine", "Spine1", "Spine2", "Spine3", "Neck", "Head"],
};

test("each bone of both variants has a name of its own in words", () => {
  for (const variant of ["Neck1", "Spine3"] as const) {
    const bones = [...Trunks[variant], ...["Left", "Right"].flatMap(side => Limbs.map(limb => side + limb))];
    const words = bones.map(bone => wordsOf(bone, variant));
    assert.equal(new Set(words).size, 59);
    for (const each of words)
      assert.match(each, /^[A-Z][a-z]+( [a-z]+)*(, [a-z]+)?$/);
  }
});

test("bones are named as people name them", () => {
  const words = ["RightUpLeg", "RightLeg", "LeftForeArm", "RightInHandIndex", "LeftHandPinky3", "RightHandThumb1"].map(bone => wordsOf(bone, "Neck1"));
  assert.deepEqual(words, [
    "Right thigh", "Right shin", "Left forearm", "Right index finger, metacarpal", "Left little finger, distal", "Right thumb, metacarpal",
  ]);
  assert.equal(wordsOf("Neck", "Neck1"), "Lower neck");
  assert.equal(wordsOf("Neck", "Spine3"), "Neck");
  assert.equal(wordsOf("Tail", "Neck1"), "Tail");
});
