import assert from "node:assert/strict";
import { test } from "node:test";
import { Gutter, type LayeredCanvas } from "../../src/takes/canvas";
import { connectSeeking } from "../../src/takes/timeline";
import { TimeView } from "../../src/takes/timeView";

test("of two fingers, the first one moves the time until it leaves", () => {
  // A browser captures each finger.
  class Target extends EventTarget {
    getBoundingClientRect = () => ({ left: 0 });
    setPointerCapture = () => {};
    hasPointerCapture = (pointer: number) => fingers.has(pointer);
    focus = () => {};
  }
  const fingers = new Set<number>();
  const target = new Target();
  const view = new TimeView();
  view.setDuration(1000);
  const done: (number | string)[] = [];
  connectSeeking(target as unknown as HTMLElement, { axis: 100 } as LayeredCanvas, view, time => done.push(time), () => done.push("end"));
  const send = (type: string, pointerId: number, x: number) =>
    target.dispatchEvent(Object.assign(new Event(type), { button: 0, pointerId, clientX: Gutter + x }));
  const press = (finger: number, x: number) => {
    send("pointerdown", finger, x);
    fingers.add(finger);
  };
  const lift = (finger: number) => {
    fingers.delete(finger);
    send("lostpointercapture", finger, 0);
  };
  press(1, 10);
  press(2, 90);
  send("pointermove", 2, 91);
  send("pointermove", 1, 11);
  lift(2);
  send("pointermove", 1, 12);
  lift(1);
  press(3, 50);
  lift(3);
  assert.deepEqual(done, [100, 110, 120, "end", 500, "end"]);
});
