import assert from "node:assert/strict";
import { test } from "node:test";
import { LayeredCanvas } from "../../src/takes/canvas";
import { setGlobals } from "../globals";

test("a canvas is drawn again on each screen with other pixels", () => {
  let query = new EventTarget();
  const canvases: { width: number }[] = [];
  setGlobals({
    document: {
      createElement: () => {
        const canvas = { width: 0, setAttribute: () => {}, getContext: () => ({ canvas }) };
        canvases.push(canvas);
        return canvas;
      },
    },
    ResizeObserver: class { observe(): void {} },
    matchMedia: (words: string) => {
      assert.equal(words, `(resolution: ${devicePixelRatio}dppx)`);
      return query = new EventTarget();
    },
    devicePixelRatio: 1,
  });
  let draws = 0;
  new LayeredCanvas({ append: () => {}, clientWidth: 100, clientHeight: 50 } as unknown as HTMLElement, () => draws++);
  for (const ratio of [1.5, 2]) {
    setGlobals({ devicePixelRatio: ratio });
    query.dispatchEvent(new Event("change"));
    assert.deepEqual(canvases.map(canvas => canvas.width), [100 * ratio, 100 * ratio]);
  }

  assert.equal(draws, 2);
});
