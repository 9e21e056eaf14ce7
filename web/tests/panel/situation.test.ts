import assert from "node:assert/strict";
import { test } from "node:test";
import type { Status } from "../../src/live/messages";
import { describe, describeTake } from "../../src/panel/situation";
import type { TakeInfo } from "../../src/takes/info";
import { performer } from "../performers";

function status(state: string, words = "", advice = ""): Status {
  return { state, words, advice, address: "192.168.1.20:7001", performers: [], bytesPerSecond: 0, reconnects: 0 };
}

test("nothing is said while a performer moves", () => {
  const situation = describe("open", "", status("receiving", "Receiving"), 1);
  assert.equal(situation.needsWords, false);
  assert.equal(situation.tone, "good");
});

test("every other state says something, and what to do", () => {
  for (const state of ["connected", "silent", "waiting", "stopped"]) {
    const situation = describe("open", "", status(state), 0);
    assert.ok(situation.needsWords && situation.title !== "" && situation.advice !== "", state);
  }

  for (const connection of ["gone", "denied"] as const)
    assert.ok(describe(connection, "The link is old.", null, 2).advice !== "", connection);
});

test("a refusal says what happened in the words of the server, and then what to do", () => {
  const situation = describe("denied", "The address has no token.", null, 0);
  assert.equal(situation.text, "The address has no token.");
  assert.match(situation.advice, /^Open the link that neuron-mocap view shows/);
});

test("the words and the advice of the server come first", () => {
  const situation = describe("open", "", status("silent", "Connected, but silent", "Check the suit."), 1);
  assert.equal(situation.title, "Connected, but silent");
  assert.equal(situation.advice, "Check the suit.");
});

test("a stream without a performer is no empty page", () => {
  assert.equal(describe("open", "", status("receiving", "Receiving"), 0).title, "No performer yet");
});

test("a problem is told although frames arrive", () => {
  const situation = describe("open", "", status("receiving", "Values without a skeleton", "Turn on displacement."), 0);
  assert.equal(situation.tone, "warning");
  assert.equal(situation.advice, "Turn on displacement.");
});

test("a take without frames is no empty stage", () => {
  const still = { ...performer(), frames: 0, start: 0, end: 0, rate: null, gaps: [] };
  const empty: TakeInfo = {
    id: "1", name: "empty.bvh", kind: "bvh", duration: 0, progress: 1, performers: [still], problems: ["The file holds a skeleton but no frames."],
  };
  const situation = describeTake(empty);
  assert.ok(situation.needsWords && situation.advice !== "");
  assert.equal(situation.title, "This take has no frames");
  assert.equal(situation.text, "The file holds a skeleton but no frames.");
  assert.ok(describeTake({ ...empty, performers: [] }).needsWords);

  // The program may find frames, and a performer who moves is enough.
  assert.equal(describeTake({ ...empty, progress: 0.5 }).needsWords, false);
  assert.equal(describeTake({ ...empty, performers: [still, { ...still, frames: 1 }] }).needsWords, false);
  assert.equal(describeTake(null).needsWords, false);
});
