import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "../../src/page/page";
import type { TakeInfo } from "../../src/takes/info";
import { Playback } from "../../src/takes/playback";
import { TakePlayer } from "../../src/takes/takePlayer";
import { performer } from "../performers";

const settle = () => new Promise(resolve => setImmediate(resolve));

// A player of one performer, whose connection opens when the test says so.
async function start() {
  let asked = 0;
  let open = (): void => {};
  const opened = new Promise<void>(resolve => { open = resolve; });
  const page = {
    api: {
      get: async () => ({ step: 64, times: [0] }),
      bytes: async () => {
        asked++;
        return new ArrayBuffer(0);
      },
    },
    connection: { opened: () => opened },
    performers: { put: () => {} },
  };
  const player = new TakePlayer(page as unknown as Page, new Playback(), "1");
  const moving = { ...performer(), frames: 10, start: 0, end: 90, rate: 100, gaps: [] };
  await player.update({ id: "1", name: "walk.bvh", kind: "bvh", duration: 90, progress: 1, performers: [moving], problems: [] } satisfies TakeInfo);
  return { player, open, asked: () => asked };
}

test("frames are asked for only while the connection is open", async () => {
  const { player, open, asked } = await start();
  assert.equal(player.isReady(0, 1), false);
  await settle();
  assert.equal(asked(), 0);
  open();
  await settle();
  assert.equal(asked(), 1);
});

test("a take that was left asks for nothing when the connection opens again", async () => {
  const { player, open, asked } = await start();
  assert.equal(player.isReady(0, 1), false);
  player.dispose();
  open();
  await settle();
  assert.equal(asked(), 0);
});
