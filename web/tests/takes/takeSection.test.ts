import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "../../src/page/page";
import type { TakeInfo } from "../../src/takes/info";
import { Playback } from "../../src/takes/playback";
import { TakeSection } from "../../src/takes/takeSection";
import { performer } from "../performers";
import { FakeElement, setElements } from "../elements";

test("while the program reads a take, its buttons stay", () => {
  setElements();
  const take = new FakeElement("section");
  const page = { slots: { take }, connection: { hello: { mode: "live" } } };
  const section = new TakeSection(page as unknown as Page, new Playback(), () => {});
  const moving = { ...performer(), frames: 10, start: 0, end: 90, rate: 100, gaps: [] };
  const info: TakeInfo = { id: "1", name: "walk.bvh", kind: "bvh", duration: 90, progress: 0.25, performers: [moving], problems: [] };
  section.show(info);
  const buttons = take.all("button");
  assert.equal(buttons.length, 5);
  assert.match(take.textContent, /25 %/);

  section.show({ ...info, progress: 0.5, performers: [{ ...moving, frames: 20 }], problems: ["A row is damaged."] });
  assert.match(take.textContent, /20 at 100 Hz.*50 %.*A row is damaged\./s);
  assert.ok(take.all("button").every((button, i) => button === buttons[i]));
  section.show({ ...info, id: "2", name: "run.bvh" });
  assert.match(take.textContent, /run\.bvh/);
  assert.ok(take.all("button").every(button => !buttons.includes(button)));
});
