import { element } from "../page/dom";
import type { Performers } from "../scene/performers";
import { iconButton, setPressed, wordButton } from "../panel/buttons";
import type { Character } from "./character";

/** What the section does with a character. */
export interface CharacterActions {
  follow(character: Character, performer: string): void;
  setBeside(character: Character, beside: boolean): void;
  plantFeet(character: Character, plants: boolean): void;
  remove(character: Character): void;
  choose(): void;
}

/** The section of the panel that lists the characters. */
export class CharacterSection {
  private readonly _list = element("ul", { class: "characters" });
  private readonly _performers: Performers;
  private readonly _actions: CharacterActions;

  constructor(place: HTMLElement, performers: Performers, actions: CharacterActions) {
    this._performers = performers;
    this._actions = actions;
    place.append(
      element("h2", {}, "Characters"),
      this._list,
      element("p", { class: "fine" }, "Drop a character here: VRM, GLB or glTF."),
      element("div", { class: "buttons" }, wordButton("open", "Open a character", () => actions.choose())));
  }

  /** Shows the characters, and the names of those that are still loading. */
  show(characters: readonly Character[], loading: readonly string[]): void {
    const focused = (document.activeElement as HTMLElement | null)?.dataset["id"];
    this._list.replaceChildren(
      ...characters.map((character, index) => this._row(character, index)),
      ...loading.map(name => element("li", {}, element("span", { class: "name" }, name, element("small", {}, "Loading…")))));
    if (focused)
      this._list.querySelector<HTMLElement>(`[data-id="${CSS.escape(focused)}"]`)?.focus();
  }

  private _row(character: Character, index: number): HTMLElement {
    const { name, plantsFeet } = character;
    const isBeside = character.place > 0;
    const beside = iconButton("figure", `Show the figure of the performer beside ${name}`, "", () => this._actions.setBeside(character, !isBeside));
    setPressed(beside, isBeside);
    beside.dataset["id"] = `beside ${index}`;
    const feet = iconButton("contacts", `Keep the feet of ${name} in place on the ground`, "", () => this._actions.plantFeet(character, !plantsFeet));
    setPressed(feet, plantsFeet);
    feet.dataset["id"] = `feet ${index}`;
    const remove = iconButton("close", `Remove ${name}`, "", () => this._actions.remove(character));
    remove.dataset["id"] = `remove ${index}`;
    return element(
      "li", {},
      element("span", { class: "name" }, name, ...(character.bones?.problems ?? []).map(problem => element("small", {}, problem))),
      beside, feet, remove, this._choice(character, index));
  }

  private _choice(character: Character, index: number): HTMLElement {
    const choice = element("select", { "aria-label": `Performer of ${character.name}` });
    choice.dataset["id"] = `performer ${index}`;
    for (const { info } of this._performers.all)
      choice.append(new Option(info.name || info.key, info.key, false, info.key === character.performer));
    choice.disabled = choice.options.length === 0;
    if (choice.disabled)
      choice.append(new Option("No performer yet"));
    choice.addEventListener("change", () => this._actions.follow(character, choice.value));
    return choice;
  }
}
