import assert from "node:assert/strict";
import { test } from "node:test";
import { BoneCount, Pose } from "../../src/live/pose";
import { blend } from "../../src/takes/blend";
import { ChunkCache, parseChunk } from "../../src/takes/chunkCache";
import { isIn, type TakePerformerInfo } from "../../src/takes/info";
import { Playback } from "../../src/takes/playback";
import { rangeOf, runsOf } from "../../src/takes/plot";
import { clock, decimalsOf, timeMark, timeStep, valueStep } from "../../src/takes/ticks";
import { TimeView } from "../../src/takes/timeView";
import { laneHeight } from "../../src/takes/timeline";
import { findLast, Track } from "../../src/takes/track";

const FrameMs = 10;

/** The server's answer: frames with a time and nothing else. */
function bytesOf(from: number, count: number): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(count * 20));
  for (let i = 0; i < count; i++) {
    view.setUint32(i * 20, 16, true);
    view.setUint32(i * 20 + 12, (from + i) * FrameMs * 1000, true);
  }

  return view.buffer;
}

const settled = async (): Promise<void> => {
  for (let i = 0; i < 200; i++)
    await Promise.resolve();
};

test("a chunk has the times of its frames", () => {
  const chunk = parseChunk(3, bytesOf(192, 64));
  assert.equal(chunk.poses.length, 64);
  assert.equal(chunk.poses[0].byteLength, 16);
  assert.deepEqual([...chunk.times.subarray(0, 2)], [1920, 1930]);
});

test("the cache loads the cursor first, then ahead, then behind, and stays bounded", async () => {
  const asked: number[] = [];
  const cache = new ChunkCache(async chunk => {
    asked.push(chunk);
    return bytesOf(chunk, 1);
  }, 16);
  cache.grow(1000);
  cache.moveTo(500, 1);
  await settled();
  assert.deepEqual(asked.slice(0, 3), [500, 501, 502]);
  assert.ok(asked.includes(499) && !asked.includes(490) && !asked.includes(520));
  for (let i = 500; i < 900; i++) {
    cache.moveTo(i, 1);
    await settled();
    assert.ok(cache.get(i), `chunk ${i}`);
    assert.ok(cache.size <= 16);
  }

  cache.moveTo(10, -1);
  await settled();
  assert.ok(cache.get(10) && cache.get(9) && cache.get(3));
});

test("a chunk that cannot be loaded is asked for again after a while, and not before", async () => {
  let asked = 0;
  let isDead = true;
  const waiting: (() => void)[] = [];
  const cache = new ChunkCache(async () => {
    asked++;
    if (isDead)
      throw new Error("gone");
    return bytesOf(0, 1);
  }, 64, run => waiting.push(run));
  cache.grow(1);
  for (let i = 0; i < 10; i++) {
    cache.moveTo(0, 1);
    await settled();
  }

  assert.equal(asked, 1);
  isDead = false;
  assert.equal(waiting.length, 1);
  waiting.pop()!();
  await settled();
  assert.equal(asked, 2);
  assert.ok(cache.get(0));
});

test("a take that is gone is not asked for again", async () => {
  const cache = new ChunkCache(async () => {
    throw new Error("closed");
  }, 64, () => assert.fail("asked again"));
  const failures: string[] = [];
  cache.onFail = error => failures.push(error.message) < 0;
  cache.grow(100);
  cache.moveTo(0, 1);
  await settled();
  cache.moveTo(50, 1);
  await settled();
  assert.deepEqual(failures, ["closed"]);
});

test("two poses are blended on the shorter way", () => {
  const [from, to] = [new Pose(), new Pose()];
  const [sin, cos] = [Math.SQRT1_2, Math.SQRT1_2];
  for (let bone = 0; bone < BoneCount; bone++) {
    from.rotations[bone * 4 + 3] = 1;
    to.rotations.set([-sin, 0, 0, -cos], bone * 4);
  }

  [from.time, to.time] = [100, 200];
  to.hips.set([1, 2, 3]);
  blend(from, to, 0.5);
  assert.equal(from.time, 150);
  assert.deepEqual([...from.hips], [0.5, 1, 1.5]);
  assert.ok(Math.abs(2 * Math.asin(from.rotations[4]) - Math.PI / 4) < 1e-6);
});

test("the lanes of all performers fit", () => {
  assert.equal(laneHeight(1), laneHeight(6));
  for (const lanes of [7, 20, 36])
    assert.ok(laneHeight(lanes) * lanes <= laneHeight(6) * 6 && laneHeight(lanes) > 0);
});

test("a track finds frames by time, also where the take grows", async () => {
  const info = { frames: 100, start: 0, end: 990, rate: 100, gaps: [] } as unknown as TakePerformerInfo;
  let frames = 100;
  const track = new Track(info, async (from, count) => bytesOf(from, Math.min(count, frames - from)));
  track.update(info, 64, [0, 640]);
  assert.equal(track.frameAt(705, 1), -1);
  await settled();
  assert.equal(track.frameAt(705, 1), 70);
  assert.equal(track.timeOf(70), 700);
  assert.equal(track.frameAt(5000, 1), 99);
  frames = 130;
  track.update({ ...info, frames: 130, end: 1290 }, 64, [0, 640, 1280]);
  track.frameAt(1275, 1);
  await settled();
  assert.equal(track.frameAt(1275, 1), 127);
  assert.equal(track.frameAt(1285, 1), 128);
});

test("a take without frames and a take of one frame", async () => {
  const none = { frames: 0, start: 0, end: 0, gaps: [] } as unknown as TakePerformerInfo;
  const empty = new Track(none, async () => assert.fail("asked for nothing"));
  empty.update(none, 64, []);
  assert.equal(empty.frameAt(0, 1), -1);
  const one = { ...none, frames: 1 };
  const track = new Track(one, async () => bytesOf(0, 1));
  track.update(one, 64, [0]);
  track.frameAt(0, 1);
  await settled();
  assert.equal(track.frameAt(0, 1), 0);
});

test("playing loops between the in and out points and stops at the end without the loop", () => {
  const playback = new Playback();
  playback.duration = 1000;
  playback.setFrom(200);
  playback.setTo(600);
  playback.toggle();
  assert.equal(playback.time, 200);
  playback.advance(350);
  playback.advance(100);
  assert.equal(playback.time, 250);
  playback.toggleLoop();
  playback.setSpeed(4);
  playback.advance(100);
  assert.equal(playback.time, 600);
  assert.equal(playback.playing, false);
  playback.toggle();
  assert.equal(playback.time, 200);
  playback.setFrom(700);
  assert.equal(playback.to, null);
  playback.seek(5000);
  assert.equal(playback.time, 1000);
});

test("a recording plays again from its first frame", () => {
  const playback = new Playback();
  [playback.duration, playback.first] = [1000, 300];
  playback.toggle();
  assert.equal(playback.time, 300);
  playback.advance(750);
  assert.equal(playback.time, 350);
});

test("a part without length is no part", () => {
  const playback = new Playback();
  [playback.duration, playback.first] = [1000, 300];
  playback.setFrom(1000);
  playback.setTo(300);
  assert.deepEqual([playback.from, playback.to], [null, null]);
  playback.setFrom(400);
  playback.setTo(300);
  assert.deepEqual([playback.from, playback.to], [400, null]);
});

test("speeds stay between 0.1 and 4", () => {
  const playback = new Playback();
  for (let i = 0; i < 10; i++)
    playback.changeSpeed(1);
  assert.equal(playback.speed, 4);
  for (let i = 0; i < 10; i++)
    playback.changeSpeed(-1);
  assert.equal(playback.speed, 0.1);
});

test("the time view zooms around a time and stays in the take", () => {
  const view = new TimeView();
  view.setDuration(10_000);
  view.zoom(0.5, 4000);
  assert.equal(view.from, 2000);
  assert.equal(view.to, 7000);
  view.pan(100_000);
  assert.equal(view.to, 10_000);
  view.reveal(0);
  assert.equal(view.from, 0);
  view.zoom(100, 0);
  assert.ok(view.isWhole);
  view.setDuration(20_000);
  assert.equal(view.to, 20_000);
});

test("marks of axes", () => {
  assert.equal(timeStep(18_000, 10), 2000);
  assert.equal(timeStep(4 * 3_600_000, 10), 1_800_000);
  assert.equal(valueStep(0.37, 4), 0.1);
  assert.equal(valueStep(0, 4), 1);
  assert.equal(decimalsOf(0.05), 2);
  assert.equal(timeMark(1500, 500), "1.5 s");
  assert.equal(timeMark(90_000, 30_000), "1:30");
  assert.equal(clock(3_723_004), "1:02:03.004");
  assert.equal(clock(59_999.9), "1:00.000");
});

test("curves break at holes and gaps", () => {
  const data = { unit: "m", times: [0, 10, 20, 500, 510, 520], min: [1, 1, 1, 1, null, 1], max: [1, 2, 1, 1, null, 1] };
  assert.deepEqual(runsOf(data, [[20, 500]]), [[0, 2], [3, 3], [5, 5]]);
  assert.deepEqual(runsOf(data, []), [[0, 3], [5, 5]]);
  assert.equal(rangeOf([]), null);
  const range = rangeOf([{ colour: "", gaps: [], data: { unit: "m", times: [0], min: [0.93], max: [0.93] } }])!;
  assert.ok(range.low < 0.93 && range.high > 0.93);
});

test("times in stretches", () => {
  const steps = [[0, 10], [20, 30]] as const;
  assert.deepEqual([-1, 0, 10, 15, 25, 31].map(time => isIn(steps, time)), [false, true, true, false, true, false]);
  assert.equal(findLast([1, 2, 3], 0), -1);
});
