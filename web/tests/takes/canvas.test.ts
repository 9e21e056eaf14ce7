import assert from "node:assert/strict";
import { test } from "node:test";
import { LayeredCanvas } from "../../src/takes/canvas";

test("a canvas is drawn again on each screen with other pixels", () => {
  let query = new EventTarget();
  const page = globalThis as Record<string, unknown>;
  const canvases: { width: number }[] = [];
  page.document = {
    createElement: () => {
      const canvas = { width: 0, setAttribute: () => {}, getContext: () => ({ canvas }) };
      canvases.push(canvas);
      return canvas;
    },
  };
  page.ResizeObserver = class { observe(): void {} };
  page.matchMedia = (words: string) => {
    assert.equal(words, `(resolution: ${page.devicePixelRatio}dppx)`);
    return query = new EventTarget();
  };
  page.devicePixelRatio = 1;
  let draws = 0;
  new LayeredCanvas({ append: () => {}, clientWidth: 100, clientHeight: 50 } as unknown as HTMLElement, () => draws++);
  for (const ratio of [1.5, 2]) {
    page.devicePixelRatio = ratio;
    query.dispatchEvent(new Event("change"));
    assert.deepEqual(canvases.map(canvas => canvas.width), [100 * ratio, 100 * ratio]);
  }

  assert.equal(draws, 2);
});
