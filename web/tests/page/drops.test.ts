import assert from "node:assert/strict";
import { test } from "node:test";
import { Drops } from "../../src/page/drops";
import { pathOf } from "../../src/page/folders";
import { FakeElement, setElements } from "../elements";

interface Entry {
  readonly isDirectory: boolean;
  readonly name: string;
}

function file(name: string, fullPath = `/${name}`): Entry {
  return { isDirectory: false, name, fullPath, file: (take: (file: File) => void) => take(new File(["1"], name)) } as Entry;
}

// As in a browser, a reader gives one part after the other.
function folder(name: string, ...inside: Entry[]): Entry {
  return { isDirectory: true, name, createReader: () => ({ readEntries: (take: (some: Entry[]) => void) => take(inside.splice(0, 2)) }) } as Entry;
}

// Drops entries. The browser gives a folder as a file that cannot be read.
async function drop(...entries: Entry[]) {
  const target = new FakeElement("body");
  const taken: string[] = [];
  const paths: string[] = [];
  const said: string[] = [];
  const drops = new Drops(target as unknown as HTMLElement, text => said.push(text));
  drops.add({ what: "anything", endings: [], accepts: () => true, take: files => void (taken.push(...files.map(each => each.name)), paths.push(...files.map(pathOf))) });
  const items = entries.map(entry => ({ webkitGetAsEntry: () => entry }));
  target.dispatchEvent(Object.assign(new Event("drop"), { dataTransfer: { items, files: entries.map(({ name }) => new File([], name)) } }));
  await new Promise(setImmediate);
  return { taken, paths, said };
}

test("a folder is dropped with all files in it", async () => {
  setElements();
  const hero = folder("hero", file("hero.gltf"), file("hero.bin"), folder("pictures", file("skin.png"), file("hair.png"), file("eyes.png")));
  const { taken, said } = await drop(file("walk.bvh"), hero);
  assert.deepEqual([taken, said], [["walk.bvh", "hero.gltf", "hero.bin", "skin.png", "hair.png", "eyes.png"], []]);
});

test("an empty folder is refused in a sentence", async () => {
  setElements();
  assert.deepEqual(await drop(folder("hero")), { taken: [], paths: [], said: ["The folder hero is empty."] });
});

test("files in folders keep their paths", async () => {
  setElements();
  const { paths } = await drop(folder("hero", file("a.gltf", "/hero/a.gltf"), folder("hair", file("colour.png", "/hero/hair/colour.png"))));
  assert.deepEqual(paths, ["hero/a.gltf", "hero/hair/colour.png"]);
  assert.deepEqual((await drop(file("walk.bvh"))).paths, ["walk.bvh"]);
});
