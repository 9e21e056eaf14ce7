import assert from "node:assert/strict";
import { test } from "node:test";
import { ServerClock } from "../../src/live/clock";

test("the fastest answer decides about the clock of the server", () => {
  const clock = new ServerClock();
  clock.add(1000, 6100, 1200);
  assert.equal(clock.offset, 5000);
  clock.add(2000, 7006, 2010);
  assert.equal(clock.offset, 5001);
  clock.add(3000, 8400, 3500);
  assert.equal(clock.offset, 5001);
});

test("old answers are forgotten: clocks drift", () => {
  const clock = new ServerClock();
  clock.add(0, 5001, 2);
  for (let i = 1; i <= 16; i++)
    clock.add(i * 1000, i * 1000 + 4010, i * 1000 + 20);
  assert.equal(clock.offset, 4000);
});

test("nothing arrives before it was sent, however slow the answers to pings are", () => {
  const clock = new ServerClock();
  clock.add(1000, 6010, 1100);
  assert.equal(clock.offset, 4960);
  clock.arrived(7000, 2010);
  assert.equal(clock.offset, 4990);
  clock.arrived(8000, 3050);
  assert.equal(clock.offset, 4990);
});
