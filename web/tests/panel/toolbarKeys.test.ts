import assert from "node:assert/strict";
import { test } from "node:test";
import { addToolbarKeys, placeAfter } from "../../src/panel/toolbarKeys";
import { setGlobals } from "../globals";

test("arrows go round in a toolbar, Home and End to its ends", () => {
  assert.equal(placeAfter("ArrowDown", 0, 3), 1);
  assert.equal(placeAfter("ArrowRight", 2, 3), 0);
  assert.equal(placeAfter("ArrowUp", 0, 3), 2);
  assert.equal(placeAfter("Home", 2, 3), 0);
  assert.equal(placeAfter("End", 0, 3), 2);
  assert.equal(placeAfter("x", 1, 3), -1);
  assert.equal(placeAfter("ArrowUp", -1, 3), -1);
});

test("after a click on a button or a choice from a list, the toolbar has the focus no more", () => {
  class FakeSelect extends EventTarget {}
  class FakeBar extends EventTarget {
    querySelectorAll = () => [];
    contains = () => true;
  }
  let blurs = 0;
  setGlobals({
    document: { activeElement: { blur: () => blurs++ } },
    HTMLSelectElement: FakeSelect,
    MutationObserver: class { observe(): void {} },
  });
  const bar = new FakeBar();
  const send = (type: string, target: EventTarget = bar): void => {
    const event = new Event(type);
    Object.defineProperty(event, "target", { value: target });
    bar.dispatchEvent(event);
  };
  addToolbarKeys(bar as unknown as HTMLElement);
  const list = new FakeSelect();

  // The space bar presses a button, and arrows choose from a list.
  send("click");
  send("change", list);
  assert.equal(blurs, 0);
  send("pointerdown");
  send("click");
  assert.equal(blurs, 1);
  send("pointerdown", list);
  send("click", list);
  assert.equal(blurs, 1);
  send("change", list);
  assert.equal(blurs, 2);
});
