import { ApiError } from "../page/api";
import type { Page, Takes } from "../page/page";
import type { Character, CharacterBones } from "./character";
import { LiveMotion } from "./liveMotion";
import { TakeMotion } from "./takeMotion";

const RetryAfter = 1000;

/** Connects a character with the server: tells it whom it follows, and gets its poses, live or from a take. */
export class CharacterMotion {
  private readonly _page: Page;
  private readonly _takes: Takes;
  private readonly _character: Character;
  private readonly _changed: () => void;
  private _source: LiveMotion | TakeMotion | null = null;
  // The take, the performer and how it is followed, or empty for nobody.
  private _goal = "";
  // Counts starts: what answers to an earlier one is too late. -1 after the end.
  private _attempt = 0;

  /** @param changed Called when the server has bound the bones. */
  constructor(page: Page, takes: Takes, character: Character, changed: () => void) {
    this._page = page;
    this._takes = takes;
    this._character = character;
    this._changed = changed;
  }

  /** Introduces the character to the server. Throws an ApiError with a sentence if the server cannot move it. */
  async introduce(): Promise<void> {
    const { skeleton, name, performer, plantsFeet: plant } = this._character;
    const { nodes, humanoid, lowest } = skeleton;
    const answer = await this._page.api.change<CharacterBones>("POST", "characters", { name, performer, variant: this._variant, nodes, humanoid, lowest, plant });
    this._character.bind(answer!);
    this._changed();
  }

  /** Follows whoever the character follows now. Call it after every change of performers, takes, connections and feet. */
  adjust(): void {
    const isOpen = this._page.connection.state === "open";
    const { performer, plantsFeet } = this._character;
    const goal = isOpen && this._page.performers.get(performer) ? `${this._takes.current ?? ""} ${performer} ${this._variant} ${plantsFeet}` : "";
    if (goal === this._goal)
      return;

    this._goal = goal;
    this._stop();
    if (goal !== "")
      void this._start(++this._attempt);
  }

  /** Shows the newest pose. Called once a picture. Returns whether there was one. */
  update(): boolean {
    const source = this._source;
    if (!source)
      return false;

    const performer = this._page.performers.get(this._character.performer);
    if (source instanceof LiveMotion) {
      const newest = source.take();
      return newest !== null && this._character.show(newest);
    }

    const view = performer?.hasPose ? source.take(performer.pose.time) : null;
    return view !== null && this._character.show(view, source.next, source.part);
  }

  /** Forgets the character here and on the server. */
  dispose(): void {
    this._stop();
    this._attempt = -1;
    const id = this._character.bones?.id;
    if (id !== undefined)
      this._page.api.change("DELETE", `characters/${id}`).catch(() => {});
  }

  private get _variant(): string | undefined {
    return this._page.performers.get(this._character.performer)?.info.variant;
  }

  private _stop(): void {
    this._attempt++;
    this._source?.close();
    this._source = null;
  }

  private async _start(attempt: number): Promise<void> {
    try {
      await this._follow();
    } catch {
      this._retry(attempt);
      return;
    }

    const id = this._character.bones?.id;
    if (attempt !== this._attempt || id === undefined)
      return;

    const take = this._takes.current;
    this._source = take === null
      ? new LiveMotion(this._page.api, id, () => this._retry(attempt))
      : new TakeMotion(this._page.api, take, this._character.performer, id);
  }

  // A program that was started again does not know the character.
  private async _follow(): Promise<void> {
    const { bones, performer, plantsFeet: plant } = this._character;
    try {
      const answer = await this._page.api.change<CharacterBones>("PUT", `characters/${bones?.id}`, { performer, variant: this._variant, plant });
      this._character.bind(answer!);
    } catch (error) {
      if (!(error instanceof ApiError) || error.status !== 404)
        throw error;
      await this.introduce();
    }
  }

  private _retry(attempt: number): void {
    setTimeout(() => {
      if (attempt !== this._attempt)
        return;

      this._source?.close();
      this._source = null;
      if (this._page.connection.state === "open")
        void this._start(attempt);
      else
        this._goal = "";
    }, RetryAfter);
  }
}
