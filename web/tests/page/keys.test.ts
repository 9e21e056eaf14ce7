import assert from "node:assert/strict";
import { test } from "node:test";
import { Keys } from "../../src/page/keys";
import { setGlobals } from "../globals";

// Keys of a document that the test presses.
function createKeys() {
  let listener = (_: KeyboardEvent): void => {};
  setGlobals({
    document: {
      addEventListener: (_: string, added: typeof listener) => { listener = added; },
      querySelector: () => null,
    },
  });
  const target = { matches: () => false };
  const keys = new Keys();
  return { keys, press: (key: string, others: Partial<KeyboardEvent> = {}) => listener({ key, target, preventDefault: () => {}, ...others } as unknown as KeyboardEvent) };
}

test("a key that is held runs once, unless it steps", () => {
  const { keys, press } = createKeys();
  const runs: string[] = [];
  keys.add({ key: "r", does: "Record", group: "", run: () => runs.push("r") }, { key: ".", does: "Step", group: "", repeats: true, run: () => runs.push(".") });
  for (const key of ["r", "."]) {
    press(key);
    press(key, { repeat: true });
    press(key, { repeat: true });
  }

  assert.deepEqual(runs, ["r", ".", ".", "."]);
});

test("a key without a use does nothing and is not listed", () => {
  const { keys, press } = createKeys();
  let isUseful = false;
  let runs = 0;
  keys.add({ key: "r", does: "Record", group: "", isUseful: () => isUseful, run: () => runs++ });
  press("r");
  assert.deepEqual([runs, keys.all.length], [0, 0]);
  isUseful = true;
  press("r");
  assert.deepEqual([runs, keys.all.length], [1, 1]);
});

test("a keyboard that needs Option for brackets has them, and no letters with Option", () => {
  const { keys, press } = createKeys();
  const runs: string[] = [];
  keys.add(...["[", "r", "1"].map(key => ({ key, does: "", group: "", run: () => runs.push(key) })));
  press("[", { altKey: true, code: "Digit5" });
  press("r", { altKey: true, code: "KeyR" });
  press("®", { altKey: true, code: "KeyR" });
  press("1", { altKey: true, code: "Digit1" });
  assert.deepEqual(runs, ["["]);
});

test("a key of another alphabet is the Latin letter in its place", () => {
  const { keys, press } = createKeys();
  const runs: string[] = [];
  keys.add(...["r", "w"].map(key => ({ key, does: "", group: "", run: () => runs.push(key) })));
  press("к", { code: "KeyR" });
  press("ς", { code: "KeyW" });
  press("é", { code: "KeyW" });
  press("о", { code: "KeyJ" });
  assert.deepEqual(runs, ["r", "w"]);
});
