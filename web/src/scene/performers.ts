import type { PerformerInfo } from "../live/messages";
import type { Stage } from "./stage";
import { Performer } from "./performer";

/** The performers on the stage, live or from a take. */
export class Performers {
  private readonly _stage: Stage;
  private readonly _byKey = new Map<string, Performer>();
  private readonly _listeners: (() => void)[] = [];

  constructor(stage: Stage) {
    this._stage = stage;
  }

  get all(): Iterable<Performer> {
    return this._byKey.values();
  }

  get(key: string): Performer | undefined {
    return this._byKey.get(key);
  }

  /** Adds a performer, or replaces it if its body, name or colour changed. */
  put(info: PerformerInfo): Performer {
    const known = this._byKey.get(info.key);
    if (known && JSON.stringify(known.info) === JSON.stringify(info))
      return known;

    known?.dispose();
    const performer = new Performer(info);
    this._byKey.set(info.key, performer);
    this._stage.scene.add(performer.group);
    this._changed();
    return performer;
  }

  remove(key: string): void {
    this._byKey.get(key)?.dispose();
    if (this._byKey.delete(key))
      this._changed();
  }

  clear(): void {
    for (const performer of this._byKey.values())
      performer.dispose();
    this._byKey.clear();
    this._changed();
  }

  /** Calls a function when performers come, go or change. */
  onChange(listener: () => void): void {
    this._listeners.push(listener);
  }

  private _changed(): void {
    for (const listener of this._listeners)
      listener();
  }
}
