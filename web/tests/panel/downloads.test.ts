import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "../../src/page/page";
import { downloadButtons } from "../../src/panel/downloads";
import { FakeElement, setElements } from "../elements";

// The names of the files that a click on BVH saves, for a take of these performers.
async function saveBvh(performers: readonly { readonly key: string; readonly name: string }[]): Promise<[string, string][]> {
  setElements();
  const saved: [string, string][] = [];
  let done: Promise<unknown> = Promise.resolve();
  const page = {
    api: { get: async () => ({ performers }), download: async (address: string, name: string) => saved.push([address, name]) },
    notices: { attempt: (work: () => Promise<unknown>) => (done = work()) },
  };
  const group = downloadButtons(page as unknown as Page, "1", "walk.nmrec") as unknown as FakeElement;
  group.all("button")[0].dispatchEvent(new Event("click"));
  await done;
  return saved;
}

test("the page also asks for a take without performers, so that it shows the sentence of the server", async () => {
  assert.deepEqual(await saveBvh([]), [["takes/1/download?format=bvh", "walk.bvh"]]);
});

test("each performer has a BVH file", async () => {
  assert.deepEqual(await saveBvh([{ key: "1-0", name: "Anna" }]), [["takes/1/download?format=bvh", "walk.bvh"]]);
  assert.deepEqual(await saveBvh([{ key: "1-0", name: "Anna" }, { key: "1-1", name: "" }]), [
    ["takes/1/download?format=bvh&performer=1-0", "walk Anna.bvh"],
    ["takes/1/download?format=bvh&performer=1-1", "walk 1-1.bvh"],
  ]);
});
