import assert from "node:assert/strict";
import { test } from "node:test";
import { bytes, count, duration, milliseconds, short } from "../../src/panel/format";

test("numbers have as many decimals as matter", () => {
  assert.deepEqual([0, 0.254, 0.999, 3.14, 9.96, 42.4, 1234].map(short), ["0", "0.25", "1.0", "3.1", "10", "42", "1234"]);
});

test("milliseconds are never negative, and may be missing", () => {
  assert.equal(milliseconds(8.12), "8.1 ms");
  assert.equal(milliseconds(-3), "0 ms");
  assert.equal(milliseconds(NaN), "–");
  assert.equal(milliseconds(null), "–");
});

test("bytes have the largest fitting unit", () => {
  assert.deepEqual([0, 999, 1000, 89_400, 999_600, 12_300_000, 5e12].map(bytes),
    ["0 B", "999 B", "1.0 kB", "89 kB", "1.0 MB", "12 MB", "5000 GB"]);
});

test("durations have hours only if needed", () => {
  assert.deepEqual([0, 7.9, 765, 3723].map(duration), ["0:00", "0:07", "12:45", "1:02:03"]);
});

test("counts have spaces between thousands", () => {
  assert.deepEqual([0, 999, 1000, 1234567].map(count), ["0", "999", "1 000", "1 234 567"]);
});
