import assert from "node:assert/strict";
import { test } from "node:test";
import { Notices } from "../../src/page/notices";
import { FakeElement, setElements } from "../elements";

test("screen readers hear what is sent, and not each percent", () => {
  setElements();
  const list = new FakeElement("div");
  const progress = new Notices(list as unknown as HTMLElement).progress("Opening walk.bvh", () => {});
  progress.show(0.37);
  const [share] = list.all("small");
  assert.equal(share.textContent, "37 %");
  assert.equal(share.attributes.get("aria-hidden"), "true");
  assert.equal(list.all("progress")[0].attributes.get("aria-label"), "Opening walk.bvh");
});
