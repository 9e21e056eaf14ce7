import assert from "node:assert/strict";
import { test } from "node:test";
import { placeAfter } from "../../src/panel/toolbarKeys";

test("arrows go round in a toolbar, Home and End to its ends", () => {
  assert.equal(placeAfter("ArrowDown", 0, 3), 1);
  assert.equal(placeAfter("ArrowRight", 2, 3), 0);
  assert.equal(placeAfter("ArrowUp", 0, 3), 2);
  assert.equal(placeAfter("Home", 2, 3), 0);
  assert.equal(placeAfter("End", 0, 3), 2);
  assert.equal(placeAfter("x", 1, 3), -1);
  assert.equal(placeAfter("ArrowUp", -1, 3), -1);
});
