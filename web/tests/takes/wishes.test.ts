import assert from "node:assert/strict";
import { test } from "node:test";
import { Wishes } from "../../src/takes/wishes";

test("the last wish counts", () => {
  const wishes = new Wishes();
  const [first, second] = [wishes.add(), wishes.add()];
  assert.deepEqual([wishes.isLast(first), wishes.isLast(second)], [false, true]);

  const third = wishes.replace();
  assert.deepEqual([wishes.isLast(second), wishes.isLast(third)], [false, true]);
});

test("wishes that fail, in any order, bring back the one before them", () => {
  for (const order of [[1, 2], [2, 1]]) {
    const wishes = new Wishes();
    const all = [wishes.add(), wishes.add(), wishes.add()];
    for (const i of order)
      wishes.withdraw(all[i]);
    assert.equal(wishes.isLast(all[0]), true);
  }
});

test("a wish that was replaced does not come back", () => {
  const wishes = new Wishes();
  const upload = wishes.add();
  wishes.replace();
  const other = wishes.add();
  wishes.withdraw(other);
  assert.equal(wishes.isLast(upload), false);
});

test("a wish that comes true ends those before it and none after it", () => {
  const wishes = new Wishes();
  const first = wishes.replace();
  const [second, third] = [wishes.add(), wishes.add()];
  wishes.fulfil(second);
  assert.deepEqual([first, second, third].map(wish => wishes.has(wish)), [false, false, true]);
  assert.equal(wishes.isLast(third), true);

  wishes.fulfil(third);
  assert.equal(wishes.isLast(third), false);
});
