import assert from "node:assert/strict";
import { test } from "node:test";
import { Scene } from "three";
import { Cast } from "../../src/characters/cast";
import type { Character } from "../../src/characters/character";
import { Pose } from "../../src/live/pose";
import type { Page, Takes } from "../../src/page/page";
import { PlaceWidth } from "../../src/scene/performer";
import { Performers } from "../../src/scene/performers";
import type { Stage } from "../../src/scene/stage";
import { performer } from "../performers";
import { makeSample, toGlb } from "./sample";

globalThis.self ??= globalThis as never;

const Stride = 1.5;

// A stage with two performers, and a cast whose characters get their poses from the test.
async function createStage(characters: number) {
  const stage = { scene: new Scene(), isSoftware: false, prepare: async () => {} };
  const performers = new Performers(stage as unknown as Stage, () => Promise.reject(new Error("There is no figure.")));
  const [anna, ben] = ["a", "b"].map((key, index) => performers.put({ ...performer(key), index }));
  let picture = (_: number, __: number): void => {};
  const page = {
    api: { change: () => Promise.resolve({ id: 1, bones: [], hipsNode: 0, problems: [] }) },
    stage,
    performers,
    feed: { onChange: () => {} },
    connection: { onState: () => {} },
    loop: { add: (_: string, handler: typeof picture) => { picture = handler; }, invalidate: () => {} },
  };
  const cast = new Cast(page as unknown as Page, {} as Takes, () => {});
  for (let i = 0; i < characters; i++)
    await cast.add({ main: new File([toGlb(makeSample({ vrm: null }))], `${i}.glb`), parts: [] } as never);

  // A picture in which everybody stands at a place of the stream.
  const show = (time: number, x: number): void => {
    const pose = new Pose();
    pose.time = time;
    pose.hips[0] = x;
    for (const each of performers.all)
      each.show(pose);
    for (const character of cast.all)
      character.show(poseOf(time, x * Stride));
    picture(time, 16);
  };
  return { cast, anna, ben, show, picture: () => picture(0, 16) };
}

function poseOf(time: number, x: number): DataView {
  const view = new DataView(new ArrayBuffer(28));
  view.setUint8(0, 1);
  view.setUint8(1, 2);
  view.setUint32(8, time * 1000, true);
  view.setFloat32(16, x, true);
  return view;
}

function assertNear(actual: number, expected: number): void {
  assert.ok(Math.abs(actual - expected) < 1e-4, `${actual} ${expected}`);
}

test("a performer stands where the character in its place stands, and alone where the stream says", async () => {
  const { cast, anna, ben, show } = await createStage(1);
  show(0, 20);
  assertNear(anna.x, 20);
  show(100, 20.2);
  assertNear(anna.x, 20 + 0.2 * Stride);
  assertNear(ben.x, 20.2);

  const [character] = cast.all;
  cast.follow(character, "b");
  assertNear(anna.x, 20.2);
  show(200, 20.4);
  show(300, 20.6);
  assertNear(ben.x, 20.4 + 0.2 * Stride);
  cast.remove(character);
  assertNear(ben.x, 20.6);
});

test("a performer that is not moved is not drawn again", async () => {
  const { anna, show, picture } = await createStage(1);
  show(0, 20);
  show(100, 20.2);
  const settings = { look: "figure", axes: false, trails: false, contacts: false } as never;
  anna.update(settings, 16);
  picture();
  assert.ok(!anna.update(settings, 16));
});

test("a character beside its performer counts as soon as it has come, and moves nothing else", async () => {
  const { cast, anna, show } = await createStage(1);
  cast.setBeside(cast.all[0], true);
  assert.ok(Number.isNaN(anna.companions[0].x));
  show(0, 20);
  assertNear(anna.companions[0].x, 20 + PlaceWidth);
  show(100, 20.2);
  assertNear(anna.x, 20.2);
});

test("a character that takes the place of its performer sends the one there beside it", async () => {
  const { cast, anna, show } = await createStage(2);
  const [first, second] = cast.all as [Character, Character];
  cast.follow(first, "a");
  cast.follow(second, "a");
  show(0, 20);
  assert.deepEqual([first.place, second.place], [0, 1]);
  cast.setBeside(second, false);
  assert.deepEqual([first.place, second.place], [1, 0]);
  show(16, 20);
  assertNear(second.hipsOnStage.x, 20);
  assertNear(first.hipsOnStage.x, 20 + PlaceWidth);
  assertNear(anna.x, 20);
});
