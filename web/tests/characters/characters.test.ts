import assert from "node:assert/strict";
import { test } from "node:test";
import { Scene } from "three";
import { createCharacters } from "../../src/characters/characters";
import type { FileTaker } from "../../src/page/drops";
import type { Page, Takes } from "../../src/page/page";
import { FakeElement, setElements } from "../elements";
import { performer } from "../performers";
import { makeSample, toGlb } from "./sample";

globalThis.self ??= globalThis as never;

// A page with one performer. The server answers when the test says so.
function createPage() {
  const takers: FileTaker[] = [];
  const choices: (readonly string[])[] = [];
  const answers: (() => void)[] = [];
  const place = new FakeElement("section");
  const anna = { info: performer(), refresh: () => {} };
  const page = {
    api: { change: () => new Promise(resolve => answers.push(() => resolve({ id: answers.length, bones: [], hipsNode: 0, problems: [] }))) },
    slots: { characters: place },
    stage: { scene: new Scene() },
    performers: { all: [anna], get: (key: string) => key === anna.info.key ? anna : undefined, onChange: () => {} },
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
  for (const name of ["a.glb", "b.glb"])
    void takers[0].take([new File([toGlb(makeSample({ vrm: null }))], name)]);
  for (let i = 0; i < 1000 && characters.list().length < 2; i++) {
    answers.pop()?.();
    await new Promise(setImmediate);
  }

  assert.deepEqual(characters.list().map(each => each.place), [0, 1]);
});
