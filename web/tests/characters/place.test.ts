import assert from "node:assert/strict";
import { test } from "node:test";
import { Group, Object3D } from "three";
import { Character } from "../../src/characters/character";
import type { LoadedCharacter } from "../../src/characters/load";
import type { Skeleton } from "../../src/characters/skeleton";
import { PlaceWidth } from "../../src/scene/performer";

// Legs that are half as long again as those of the performer, so all ways are.
const Stride = 1.5;

// A character whose file has centimetres and lies on its back.
function createCharacter(): Character {
  const root = new Group();
  root.scale.setScalar(0.01);
  root.rotation.x = -Math.PI / 2;
  const hips = new Object3D();
  root.add(hips);
  const character = new Character({ name: "long.glb", root, vrm: null } as unknown as LoadedCharacter, { objects: [hips] } as unknown as Skeleton);
  character.bind({ id: 1, bones: [], hipsNode: 0, problems: [] });
  return character;
}

function show(character: Character, time: number, x: number, z: number): void {
  const view = new DataView(new ArrayBuffer(28));
  view.setUint8(0, 1);
  view.setUint8(1, 2);
  view.setUint32(8, time * 1000, true);
  view.setFloat32(16, x * Stride * 100, true);
  view.setFloat32(20, -z * Stride * 100, true);
  view.setFloat32(24, 100, true);
  assert.ok(character.show(view));
}

// Where the hips are, when the pose of the performer has come as well.
function come(character: Character, x: number, z: number, time: number): [number, number] {
  character.accompany(x, z, time);
  character.accompany(x, z, time);
  return [character.hipsOnStage.x, character.hipsOnStage.z];
}

function assertNear(actual: readonly number[], expected: readonly number[]): void {
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-4, `${actual} ${expected}`));
}

test("a character comes to its performer, and walks on with its own stride", () => {
  const character = createCharacter();
  show(character, 0, 20, -4);
  assertNear(come(character, 20, -4, 0), [20, -4]);
  show(character, 16, 20.1, -4);
  assertNear(come(character, 20.1, -4, 16), [20 + 0.1 * Stride, -4]);
});

test("a character comes again after a jump", () => {
  const character = createCharacter();
  show(character, 0, 20, -4);
  come(character, 20, -4, 0);
  show(character, 16, 2, 3);
  assertNear(come(character, 2, 3, 16), [2, 3]);
  character.hide();
  show(character, 32, 2.1, 3);
  assertNear(come(character, 2.1, 3, 32), [2.1, 3]);
});

test("a character comes to the pose of the same time", () => {
  const character = createCharacter();
  show(character, 100, 1, 0);
  assertNear(come(character, 0.9, 0, 84), [0.9, 0]);
  assertNear(come(character, 1, 0, 100), [1, 0]);
  assertNear(come(character, 1.1, 0, 116), [1, 0]);
});

test("a character beside its performer keeps its distance in every place", () => {
  const character = createCharacter();
  assert.ok(Number.isNaN(character.hipsOnStage.x));
  character.place = 1;
  show(character, 0, 5, 0);
  assertNear(come(character, 5, 0, 0), [5 + PlaceWidth, 0]);
  show(character, 16, 5.1, 0);
  assertNear(come(character, 5.1, 0, 16), [5 + PlaceWidth + 0.1 * Stride, 0]);
  character.place = 2;
  assertNear(come(character, 5.1, 0, 16), [5.1 + 2 * PlaceWidth, 0]);
  character.hide();
  assert.ok(Number.isNaN(character.hipsOnStage.x));
});

test("fast play is no jump, and the start of a loop or another time is one", () => {
  const character = createCharacter();
  show(character, 0, 0, 0);
  come(character, 0, 0, 0);
  show(character, 400, 4, 0);
  assertNear(come(character, 4, 0, 400), [4 * Stride, 0]);
  show(character, 0, 3.9, 0);
  assertNear(come(character, 3.9, 0, 0), [3.9, 0]);
  show(character, 3000, 4, 0);
  assertNear(come(character, 4, 0, 3000), [4, 0]);
});

test("a character whose poses never have the time of the performer's comes after some pictures", () => {
  const character = createCharacter();
  let fits = false;
  for (let picture = 0; picture < 100 && !fits; picture++) {
    show(character, picture * 100, 1, 0);
    fits = character.accompany(1, 0, picture * 100 + 40);
  }

  assert.ok(fits);
  assertNear([character.hipsOnStage.x], [1]);
});
