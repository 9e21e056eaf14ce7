import assert from "node:assert/strict";
import { test } from "node:test";
import { Scene } from "three";
import { createCharacters } from "../../src/characters/characters";
import type { FileTaker } from "../../src/page/drops";
import type { Characters, Page, Takes } from "../../src/page/page";
import { FakeElement, setElements } from "../elements";
import { performer } from "../performers";
import { makeSample, toGlb } from "./sample";

globalThis.self ??= globalThis as never;

// A page with performers, by default one. The server answers when the test says so.
function createPage(...people: { key: string; hidden: boolean }[]) {
  const takers: FileTaker[] = [];
  const choices: (readonly string[])[] = [];
  const answers: (() => void)[] = [];
  const place = new FakeElement("section");
  const all = (people.length > 0 ? people : [{ key: "0-0", hidden: false }]).map(({ key, hidden }) => ({
    info: performer(key), hidden, standAlone: () => {}, refresh: () => {},
  }));
  const page = {
    api: { change: () => new Promise(resolve => answers.push(() => resolve({ id: answers.length, bones: [], hipsNode: 0, problems: [] }))) },
    slots: { characters: place },
    stage: { scene: new Scene() },
    performers: { all, get: (key: string) => all.find(each => each.info.key === key), onChange: () => {} },
    feed: { onChange: () => {} },
    connection: { onState: () => {} },
    loop: { add: () => {} },
    notices: { attempt: (work: () => Promise<unknown>) => work() },
    drops: { add: (taker: FileTaker) => takers.push(taker), choose: (endings: readonly string[]) => choices.push(endings) },
  };
  const characters = createCharacters(page as unknown as Page, {} as Takes);
  return { takers, choices, place, answers, characters };
}

test("the dialogs for characters show the buffers and pictures of a .gltf", () => {
  setElements();
  const { takers, choices, place } = createPage();
  place.all("button")[0].dispatchEvent(new Event("click"));
  for (const shown of [choices[0], takers[0].endings]) {
    for (const ending of [".vrm", ".glb", ".gltf", ".bin", "image/*"])
      assert.ok(shown.includes(ending), ending);
  }
});

test("characters that are dropped one soon after the other have places of their own", async () => {
  setElements();
  const { takers, answers, characters } = createPage();
  await drop(2, takers, answers, characters);
  assert.deepEqual(characters.list().map(each => each.place), [0, 1]);
});

test("a dropped character follows a performer who is shown", async () => {
  setElements();
  const { takers, answers, characters } = createPage({ key: "a", hidden: true }, { key: "b", hidden: false }, { key: "c", hidden: true });
  await drop(2, takers, answers, characters);
  assert.deepEqual(characters.list().map(each => each.performer), ["b", "b"]);
});

test("while nobody is shown, characters follow those who are hidden", async () => {
  setElements();
  const { takers, answers, characters } = createPage({ key: "a", hidden: true }, { key: "b", hidden: true });
  await drop(2, takers, answers, characters);
  assert.deepEqual(characters.list().map(each => each.performer), ["a", "b"]);
});

async function drop(count: number, takers: FileTaker[], answers: (() => void)[], characters: Characters): Promise<void> {
  for (let i = 0; i < count; i++)
    void takers[0].take([new File([toGlb(makeSample({ vrm: null }))], `${i}.glb`)]);
  for (let i = 0; i < 1000 && characters.list().length < count; i++) {
    answers.pop()?.();
    await new Promise(setImmediate);
  }
}
