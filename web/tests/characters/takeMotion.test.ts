import assert from "node:assert/strict";
import { test } from "node:test";
import { findLast, split, TakeMotion } from "../../src/characters/takeMotion";
import { timeOf } from "../../src/characters/pose";
import type { Api } from "../../src/page/api";

const Step = 64;
const settled = () => new Promise<void>(resolve => setImmediate(resolve));

// A take of frames that are ten milliseconds apart.
class Server {
  readonly requests: string[] = [];
  isComplete = true;

  constructor(public frames: number) {}

  get api(): Api {
    return {
      get: async () => ({ step: Step, times: Array.from({ length: Math.ceil(this.frames / Step) }, (_, i) => i * Step * 10), isComplete: this.isComplete }),
      bytes: async (path: string) => {
        this.requests.push(path);
        const query = new URLSearchParams(path.split("?")[1]);
        const from = Number(query.get("from"));
        const end = Math.min(this.frames, from + Number(query.get("count")));
        const answer = new DataView(new ArrayBuffer(Math.max(0, end - from) * 32));
        for (let i = 0; i < end - from; i++) {
          answer.setUint32(i * 32, 28, true);
          answer.setUint32(i * 32 + 12, (from + i) * 10_000, true);
        }

        return answer.buffer;
      },
    } as unknown as Api;
  }
}

async function open(server: Server): Promise<{ motion: TakeMotion; at(time: number): Promise<number | null>; wait(): void }> {
  let now = 0;
  const motion = new TakeMotion(server.api, "t1", "t1-0", 3, () => now);
  const at = async (time: number) => {
    const first = motion.take(time);
    await settled();
    await settled();
    const pose = motion.take(time) ?? first;
    return pose ? timeOf(pose) : null;
  };
  await at(0);
  return { motion, at, wait: () => { now += 5000; } };
}

test("the pose of a time is that of the last frame at or before it", async () => {
  const { at, motion } = await open(new Server(1000));
  assert.equal(await at(1234), 1230);
  assert.equal(motion.take(1234), null);
  assert.equal(timeOf(motion.take(1240)!), 1240);
  assert.equal(await at(-50), 0);
  assert.equal(await at(1e9), 9990);
});

test("between two frames, a character is on its way to the next one", async () => {
  const { at, motion } = await open(new Server(1000));
  await at(1230);
  assert.equal(motion.part, 0);
  assert.equal(timeOf(motion.take(1232.5)!), 1230);
  assert.equal(motion.part, 0.25);
  assert.equal(timeOf(motion.next!), 1240);
  motion.take(1279);
  assert.equal(timeOf(motion.next!), 1280);
  await at(9990);
  assert.equal(motion.next, null);
});

test("the next block is read ahead, and a block only once", async () => {
  const server = new Server(1000);
  const { at } = await open(server);
  assert.equal(server.requests.length, 2);
  await at(700);
  assert.equal(server.requests.length, 3);
  await at(10);
  assert.equal(server.requests.length, 3);
  assert.ok(server.requests[0].startsWith("takes/t1/characters/3/poses?performer=t1-0&from=0&count=64"));
});

test("a take that is still read grows", async () => {
  const server = new Server(70);
  const { at, wait } = await open(server);
  assert.equal(await at(900), 690);
  server.frames = 500;
  await at(100);
  assert.equal(await at(900), 690);
  wait();
  assert.equal(await at(900), 900);
});

test("a block that was loaded before its take was complete is loaded once more", async () => {
  const server = new Server(1000);
  server.isComplete = false;
  const { at, wait } = await open(server);
  await at(100);
  assert.equal(server.requests.length, 2);
  wait();
  await at(100);
  assert.equal(server.requests.length, 2);

  server.isComplete = true;
  for (let i = 0; i < 3; i++) {
    wait();
    await at(100);
    await at(100);
    assert.equal(server.requests.length, 4);
  }

  assert.deepEqual(server.requests.slice(2), server.requests.slice(0, 2));
});

test("few blocks are kept", async () => {
  const server = new Server(64 * 200);
  const { at } = await open(server);
  for (let block = 0; block < 199; block++)
    await at(block * 640);

  const before = server.requests.length;
  await at(195 * 640);
  assert.equal(server.requests.length, before);
  await at(0);
  assert.ok(server.requests.length > before);
});

test("answers are cut into poses, and values are found", () => {
  assert.deepEqual(split(new ArrayBuffer(0)), []);
  assert.deepEqual(split(new Uint8Array([2, 0, 0, 0, 9, 9, 200, 0, 0, 0, 1]).buffer).map(view => view.byteLength), [2]);
  const values = [1, 3, 5];
  assert.deepEqual([0, 1, 2, 3, 4, 5, 9].map(limit => findLast(3, i => values[i], limit)), [0, 0, 0, 1, 1, 2, 2]);
});
