import assert from "node:assert/strict";
import { test } from "node:test";
import type { Keys, Shortcut } from "../../src/page/keys";
import { Playback } from "../../src/takes/playback";
import { Transport } from "../../src/takes/transport";
import { setElements } from "../elements";
import { setGlobals } from "../globals";

test("End shows the last frame, also of a take that is played again and again", () => {
  setElements();
  setGlobals({ MutationObserver: class { observe(): void {} } });
  const playback = new Playback();
  [playback.duration, playback.loop] = [1000, true];
  const transport = new Transport(playback, { step: () => {}, seek: time => playback.seek(time), togglePlot: () => {}, showAll: () => {} });
  const shortcuts: Shortcut[] = [];
  transport.addKeys({ add: (...keys: Shortcut[]) => shortcuts.push(...keys) } as unknown as Keys);
  const press = (key: string) => shortcuts.find(each => each.key === key)!.run();
  playback.toggle();
  playback.advance(300);
  press("End");
  playback.advance(400);
  assert.equal(playback.time, 1000);

  press(" ");
  assert.equal(playback.time, 0);
});
