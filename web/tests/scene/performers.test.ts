import assert from "node:assert/strict";
import { test } from "node:test";
import { Scene } from "three";
import { Performers } from "../../src/scene/performers";
import type { Stage } from "../../src/scene/stage";
import { makeSample, toGlb } from "../characters/sample";
import { performer } from "../performers";

globalThis.self ??= globalThis as never;

test("a figure that did not arrive is asked for again, once at a time", async () => {
  const bytes = await new Blob([toGlb(makeSample({ vrm: null }))]).arrayBuffer();
  const answers = [Promise.reject(new Error("The program does not answer.")), Promise.resolve(bytes)];
  const stage = { scene: new Scene(), isSoftware: false, prepare: async () => {} };
  let asked = 0;
  const performers = new Performers(stage as unknown as Stage, () => answers[asked++] ?? assert.fail("asked too often"));
  const shown = performers.put(performer());
  performers.put(performer());
  assert.equal(asked, 1);
  for (let i = 0; i < 1000 && !shown.hasFigure; i++) {
    performers.put(performer());
    await new Promise(setImmediate);
  }

  assert.ok(shown.hasFigure);
  assert.equal(asked, 2);
  performers.put(performer());
  assert.equal(asked, 2);
});
