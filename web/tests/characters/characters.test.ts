import assert from "node:assert/strict";
import { test } from "node:test";
import { createCharacters } from "../../src/characters/characters";
import type { FileTaker } from "../../src/page/drops";
import type { Page, Takes } from "../../src/page/page";
import { FakeElement } from "../elements";

// A page without performers.
function createPage() {
  const takers: FileTaker[] = [];
  const choices: (readonly string[])[] = [];
  const place = new FakeElement("section");
  const page = {
    slots: { characters: place },
    performers: { all: [], onChange: () => {} },
    feed: { onChange: () => {} },
    connection: { onState: () => {} },
    loop: { add: () => {} },
    drops: { add: (taker: FileTaker) => takers.push(taker), choose: (endings: readonly string[]) => choices.push(endings) },
  };
  createCharacters(page as unknown as Page, {} as Takes);
  return { takers, choices, place };
}

test("the dialogs for characters show the buffers and pictures of a .gltf", () => {
  const { takers, choices, place } = createPage();
  place.all("button")[0].dispatchEvent(new Event("click"));
  for (const shown of [choices[0], takers[0].endings]) {
    for (const ending of [".vrm", ".glb", ".gltf", ".bin", "image/*"])
      assert.ok(shown.includes(ending), ending);
  }
});
