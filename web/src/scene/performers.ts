import { Vector2 } from "three";
import type { PerformerInfo } from "../live/messages";
import type { Settings } from "../page/settings";
import { Figure } from "./figure";
import { Performer } from "./performer";
import type { Stage } from "./stage";

/** The performers on the stage, live or from a take. */
export class Performers {
  private readonly _stage: Stage;
  private readonly _byKey = new Map<string, Performer>();
  private readonly _byIndex = new Map<number, Performer>();
  private readonly _loading = new Set<Performer>();
  private readonly _listeners: (() => void)[] = [];
  private readonly _pictureSize = new Vector2();
  private readonly _figureOf: (key: string) => Promise<ArrayBuffer>;

  /** @param figureOf The bytes of the GLB file of a performer's figure. */
  constructor(stage: Stage, figureOf: (key: string) => Promise<ArrayBuffer>) {
    this._stage = stage;
    this._figureOf = figureOf;
  }

  get all(): Iterable<Performer> {
    return this._byKey.values();
  }

  get count(): number {
    return this._byKey.size;
  }

  /** Whether the stage shows somebody. */
  get anyPosed(): boolean {
    for (const performer of this._byKey.values()) {
      if (performer.hasPose)
        return true;
    }

    return false;
  }

  get(key: string): Performer | undefined {
    return this._byKey.get(key);
  }

  /** The performer with a number in compact poses. */
  withIndex(index: number): Performer | undefined {
    return this._byIndex.get(index);
  }

  /** Adds a performer, or replaces it if its body, name or colour changed. */
  put(info: PerformerInfo): Performer {
    const known = this._byKey.get(info.key);
    if (known && JSON.stringify(known.info) === JSON.stringify(info)) {
      void this._loadFigure(known);
      return known;
    }

    known?.dispose();
    const performer = new Performer(info, this._pictureSize, this._stage.isSoftware);
    if (known?.hasPose)
      performer.show(known.pose);
    performer.hidden = known?.hidden ?? false;
    performer.figureReplaced = known?.figureReplaced ?? false;
    performer.companions = known?.companions ?? [];
    performer.group.position.copy(known?.group.position ?? performer.group.position);
    this._byKey.set(info.key, performer);
    this._byIndex.set(info.index, performer);
    this._stage.scene.add(performer.group);
    void this._loadFigure(performer);
    this._changed();
    return performer;
  }

  remove(key: string): void {
    const performer = this._byKey.get(key);
    if (!performer)
      return;

    performer.dispose();
    this._byKey.delete(key);
    this._byIndex.delete(performer.info.index);
    this._changed();
  }

  clear(): void {
    for (const key of [...this._byKey.keys()])
      this.remove(key);
  }

  /** Calls a function when performers come, go or change. */
  onChange(listener: () => void): void {
    this._listeners.push(listener);
  }

  /** Shows or hides a performer. */
  setHidden(key: string, hidden: boolean): void {
    const performer = this._byKey.get(key);
    if (!performer)
      return;

    performer.hidden = hidden;
    this.refresh();
    this._changed();
  }

  /** What is visible has changed without a new pose. */
  refresh(): void {
    for (const performer of this._byKey.values())
      performer.refresh();
  }

  /** Moves all performers to their newest poses. Returns whether the picture changes. */
  update(settings: Settings, step: number): boolean {
    this._stage.renderer.getDrawingBufferSize(this._pictureSize);
    let changed = false;
    for (const performer of this._byKey.values())
      changed = performer.update(settings, step) || changed;
    return changed;
  }

  // The sticks stay if there is no figure. The next message about the performer asks for it again.
  private async _loadFigure(performer: Performer): Promise<void> {
    if (performer.hasFigure || this._loading.has(performer))
      return;

    this._loading.add(performer);
    try {
      const figure = await Figure.load(this._figureOf(performer.info.key), performer.body, this._stage.isSoftware);
      await this._stage.prepare(figure.root);
      if (this._byKey.get(performer.info.key) === performer)
        performer.setFigure(figure);
      else
        figure.dispose();
    } catch {
      performer.refresh();
    } finally {
      this._loading.delete(performer);
    }
  }

  private _changed(): void {
    for (const listener of this._listeners)
      listener();
  }
}
