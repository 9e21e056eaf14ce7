import type { Characters, Page, Takes } from "../page/page";
import { pathOf } from "../page/folders";
import { Cast } from "./cast";
import { CharacterChoices, findCharacters } from "./files";
import { CharacterSection } from "./section";

/** Characters dropped on the page, and how they move. */
export function createCharacters(page: Page, takes: Takes): Characters {
  const cast: Cast = new Cast(page, takes, () => section.show(cast.all, cast.loading));
  const section = new CharacterSection(page.slots.characters, page.performers, {
    follow: (character, performer) => cast.follow(character, performer),
    setBeside: (character, beside) => cast.setBeside(character, beside),
    plantFeet: (character, plants) => cast.plantFeet(character, plants),
    remove: character => cast.remove(character),
    choose: () => page.drops.choose(CharacterChoices),
  });
  section.show([], []);
  let last: Promise<unknown> = Promise.resolve();
  page.drops.add({
    what: "characters (VRM, GLB, glTF)",
    endings: CharacterChoices,
    accepts: files => findCharacters(files).length > 0,
    take: files => {
      // One after the other, also those of several drops, so that each finds a performer and a place of its own.
      for (const found of findCharacters(files, pathOf))
        last = last.then(() => page.notices.attempt(() => cast.add(found)));
    },
  });
  return {
    joints: id => cast.all.find(character => `${character.bones?.id}` === id)?.joints() ?? {},
    list: () => cast.all.map(({ name, performer, bones, isShown, place }) => ({ id: `${bones?.id}`, name, performer, isShown, place })),
  };
}
