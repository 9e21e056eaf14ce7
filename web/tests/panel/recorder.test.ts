import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page, Takes } from "../../src/page/page";
import { Recorder } from "../../src/panel/recorder";
import { FakeElement, setElements } from "../elements";

test("after another hello, only the recordings of this run of the program are listed", () => {
  setElements();
  const said: string[] = [];
  const place = new FakeElement("section");
  const page = { keys: { add: () => {} }, notices: { say: (text: string) => said.push(text) } };
  const recorder = new Recorder(page as unknown as Page, {} as Takes, place as unknown as HTMLElement);
  const list = place.all("ul")[0];
  const finished = { state: "finished", file: "takes/a.nmrec", seconds: 3, bytes: 1000, frames: 180, take: "1" };
  recorder.show(finished);
  recorder.show({ ...finished, state: "recording", file: "takes/b.nmrec", take: null });
  assert.match(list.textContent, /a\.nmrec/);

  recorder.clear();
  assert.equal(list.textContent, "");
  recorder.show(finished);
  assert.match(list.textContent, /a\.nmrec/);
  assert.deepEqual(said, []);
});

test("a recording without motion says so, and offers its own file only", () => {
  setElements();
  const place = new FakeElement("section");
  const page = { keys: { add: () => {} }, notices: { say: () => {} } };
  const recorder = new Recorder(page as unknown as Page, {} as Takes, place as unknown as HTMLElement);
  const list = place.all("ul")[0];
  const words = () => list.all("button").map(button => button.textContent.trim());
  recorder.show({ state: "idle", file: "empty.nmrec", seconds: 1, bytes: 0, frames: 0, take: "1" });
  assert.match(list.textContent, /0:01 · 0 B · no motion/);
  assert.deepEqual(words(), [".nmrec"]);

  recorder.clear();
  recorder.show({ state: "idle", file: "walk.nmrec", seconds: 1, bytes: 9000, frames: 60, take: "2" });
  assert.doesNotMatch(list.textContent, /no motion/);
  assert.deepEqual(words(), ["Show", "BVH", "GLB", "CSV", ".nmrec"]);
});
