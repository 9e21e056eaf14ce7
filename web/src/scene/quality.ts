import type { Stage } from "./stage";

const Levels = [
  { pixels: 2, shadows: 2048 },
  { pixels: 1.25, shadows: 1024 },
  { pixels: 1, shadows: 512 },
  { pixels: 0.75, shadows: 512 },
  { pixels: 0.6, shadows: 0 },
] as const;

const SoftwareLevel = 4;
const TooSlow = 40;

/** A single long step is something else, such as a file that is read. */
const LongestStep = 100;
const SlowFor = 800;

/** Draws with fewer pixels and coarser shadows where the graphics are slow. It never returns to more: a change would show. */
export class Quality {
  private readonly _stage: Stage;
  private _level = 0;
  private _slow = 0;

  constructor(stage: Stage) {
    this._stage = stage;
    if (stage.isSoftware)
      this._use(SoftwareLevel);
  }

  get level(): number {
    return this._level;
  }

  /** Judges the time between two pictures in a row, in milliseconds. */
  judge(step: number): void {
    if (step > TooSlow)
      this._slow += Math.min(step, LongestStep);
    else
      this._slow = Math.max(0, this._slow - 2 * TooSlow);
    if (this._slow < SlowFor || this._level === Levels.length - 1)
      return;

    this._slow = 0;
    this._use(this._level + 1);
  }

  private _use(level: number): void {
    this._level = level;
    const { pixels, shadows } = Levels[level];
    this._stage.setQuality(pixels, shadows);
  }
}
