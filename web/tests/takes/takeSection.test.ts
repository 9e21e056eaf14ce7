import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "../../src/page/page";
import type { TakeInfo } from "../../src/takes/info";
import { Playback } from "../../src/takes/playback";
import { TakeSection } from "../../src/takes/takeSection";
import { performer } from "../performers";
import { FakeElement, setElements } from "../elements";

const moving = { ...performer(), frames: 10, start: 0, end: 90, rate: 100, gaps: [] };
const walk: TakeInfo = { id: "1", name: "walk.bvh", kind: "bvh", duration: 90, progress: 0.25, performers: [moving], problems: [] };

test("while the program reads a take, its buttons stay", () => {
  setElements();
  const take = new FakeElement("section");
  const page = { slots: { take }, connection: { hello: { mode: "live" } } };
  const section = new TakeSection(page as unknown as Page, new Playback(), () => {});
  section.show(walk);
  const buttons = take.all("button");
  assert.equal(buttons.length, 5);
  assert.match(take.textContent, /25 %/);

  section.show({ ...walk, progress: 0.5, performers: [{ ...moving, frames: 20 }], problems: ["A row is damaged."] });
  assert.match(take.textContent, /20 at 100 Hz.*50 %.*A row is damaged\./s);
  assert.ok(take.all("button").every((button, i) => button === buttons[i]));
  section.show({ ...walk, id: "2", name: "run.bvh" });
  assert.match(take.textContent, /run\.bvh/);
  assert.ok(take.all("button").every(button => !buttons.includes(button)));
});

test("a take that was dropped on the page of a file leads back to this file", () => {
  setElements();
  const take = new FakeElement("section");
  const page = { slots: { take }, connection: { hello: { mode: "take", take: "1", source: "takes/walk.bvh" } } };
  let returns = 0;
  const section = new TakeSection(page as unknown as Page, new Playback(), () => returns++);
  section.show(walk);
  assert.doesNotMatch(take.textContent, /Back to/);

  section.show({ ...walk, id: "2", name: "run.bvh" });
  const back = take.all("button").find(button => /Back to walk\.bvh$/.test(button.textContent))!;
  back.dispatchEvent(new Event("click"));
  assert.equal(returns, 1);
});
