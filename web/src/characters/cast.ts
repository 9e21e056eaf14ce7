import type { Page, Takes } from "../page/page";
import { describeMissing } from "../page/scripts";
import { Character } from "./character";
import { freeObject } from "./dispose";
import type { CharacterFiles } from "./files";
import { CharacterMotion } from "./motion";
import { describeSkeleton } from "./skeleton";

/** The characters on the stage: who follows whom, and where. */
export class Cast {
  /** Names of the files that are being loaded. */
  readonly loading: string[] = [];
  private readonly _page: Page;
  private readonly _takes: Takes;
  private readonly _changed: () => void;
  private readonly _motions = new Map<Character, CharacterMotion>();

  constructor(page: Page, takes: Takes, changed: () => void) {
    this._page = page;
    this._takes = takes;
    this._changed = changed;
    page.performers.onChange(() => this._assign());
    page.feed.onChange(() => this._assign());
    page.connection.onState(() => this._adjust());
    page.loop.add("scene", (_, step) => this._update(step));
  }

  get all(): Character[] {
    return [...this._motions.keys()];
  }

  /** Loads a character, and shows it as soon as a performer moves. Throws an Error with a sentence. */
  async add(files: CharacterFiles<File>): Promise<void> {
    const { name } = files.main;
    this.loading.push(name);
    this._changed();
    try {
      await this._load(files);
    } finally {
      this.loading.splice(this.loading.indexOf(name), 1);
      this._assign();
    }
  }

  follow(character: Character, performer: string): void {
    if (performer !== character.performer)
      character.hide();
    character.performer = performer;
    character.chosen = performer;
    character.place = this._freePlace(character);
    this._assign();
  }

  /** Shows a character next to the figure of its performer, or in its place. */
  setBeside(character: Character, beside: boolean): void {
    const inPlace = this._followersOf(character.performer)[0];
    character.isBeside = beside;
    character.place = beside ? this._freePlace(character) : 0;
    if (!beside && inPlace.place === 0 && inPlace !== character)
      inPlace.place = this._freePlace(inPlace);
    this._assign();
  }

  /** Keeps the feet in their place while they touch the ground, or lets them slide. */
  plantFeet(character: Character, plants: boolean): void {
    character.plantsFeet = plants;
    this._assign();
  }

  remove(character: Character): void {
    this._motions.get(character)?.dispose();
    this._motions.delete(character);
    character.dispose();
    this._assign();
    this._page.loop.invalidate();
  }

  private async _load(files: CharacterFiles<File>): Promise<void> {
    const { loadCharacter } = await import("./load").catch(() => {
      throw new Error(describeMissing(this._page.connection.state));
    });
    const loaded = await loadCharacter(files);
    let character: Character;
    try {
      character = new Character(loaded, describeSkeleton(loaded));
      character.performer = this._leastFollowed();
      character.place = this._freePlace(character);
      const motion = new CharacterMotion(this._page, this._takes, character, this._changed);
      await motion.introduce();
      this._motions.set(character, motion);
    } catch (error) {
      freeObject(loaded.root);
      throw error;
    }

    this._page.stage.scene.add(character.group);
  }

  private _assign(): void {
    const { performers } = this._page;
    for (const character of this._motions.keys()) {
      const performer = this._performerFor(character);
      if (performer !== character.performer || !performers.get(performer))
        character.hide();
      if (performer !== character.performer) {
        character.performer = performer;
        character.place = this._freePlace(character);
      }

      character.isHidden = performers.get(performer)?.hidden ?? false;
    }

    for (const performer of this._page.performers.all) {
      const followers = this._followersOf(performer.info.key);
      performer.companions = followers.filter(each => each.place > 0).map(each => each.hipsOnStage);
      const isReplaced = followers.some(each => each.place === 0);
      if (performer.figureReplaced === isReplaced)
        continue;

      performer.figureReplaced = isReplaced;
      performer.standAlone();
      performer.refresh();
    }

    this._adjust();
    this._changed();
  }

  private _adjust(): void {
    for (const motion of this._motions.values())
      motion.adjust();
  }

  private _update(step: number): void {
    for (const [character, motion] of this._motions) {
      motion.update();
      this._accompany(character);
      if (character.update(step))
        this._page.loop.invalidate();
    }
  }

  // Marks, trails and the name of a performer go with the character in its place, and so does the camera.
  private _accompany(character: Character): void {
    const performer = this._page.performers.get(character.performer);
    if (!performer?.hasPose || !character.isShown)
      return;

    const { positions } = performer.body;
    const fits = character.accompany(positions[0], positions[2], performer.pose.time);
    if (fits && character.place === 0)
      performer.standAt(character.hipsOnStage.x, character.hipsOnStage.z);
  }

  // A character whose performer has left follows another one. Performers come one at a time, so a character that shares its performer moves to the next one
  // that joins.
  private _performerFor(character: Character): string {
    const { performers } = this._page;
    const { performer, chosen } = character;
    if (performers.get(chosen))
      return chosen;

    const other = this._leastFollowed();
    if (!performers.get(performer))
      return other || performer;

    const isNearest = this._followersOf(performer)[0] === character;
    const isOtherFree = this._followersOf(other).length === 0;
    return isNearest || !isOtherFree ? performer : other;
  }

  // The one that stands nearest to the performer's own place comes first.
  private _followersOf(performer: string): Character[] {
    return this.all.filter(each => each.performer === performer).sort((a, b) => a.place - b.place);
  }

  // Empty if there is no performer. Nobody would see a character of a hidden one.
  private _leastFollowed(): string {
    const everybody = [...this._page.performers.all];
    const seen = everybody.filter(each => !each.hidden);
    let least = "";
    let fewest = Infinity;
    for (const { info } of seen.length > 0 ? seen : everybody) {
      const count = this._followersOf(info.key).length;
      if (count < fewest) {
        least = info.key;
        fewest = count;
      }
    }

    return least;
  }

  // The first place that no other character of the performer has. Place 0 is the performer's own.
  private _freePlace(character: Character): number {
    const taken = new Set(this.all.filter(each => each !== character && each.performer === character.performer).map(each => each.place));
    let place = character.isBeside ? 1 : 0;
    while (taken.has(place))
      place++;
    return place;
  }
}
