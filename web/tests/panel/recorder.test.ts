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
  const finished = { state: "finished", file: "takes/a.nmrec", seconds: 3, bytes: 1000, take: "1" };
  recorder.show(finished);
  recorder.show({ ...finished, state: "recording", file: "takes/b.nmrec", take: null });
  assert.match(list.textContent, /a\.nmrec/);

  recorder.clear();
  assert.equal(list.textContent, "");
  recorder.show(finished);
  assert.match(list.textContent, /a\.nmrec/);
  assert.deepEqual(said, []);
});
