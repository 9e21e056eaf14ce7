import type { Stage } from "./stage";

const Levels = [
  { pixels: 2, shadows: 2048 },
  { pixels: 1.25, shadows: 1024 },
  { pixels: 1, shadows: 512 },
  { pixels: 0.75, shadows: 512 },
] as const;

const TooSlow = 40;
const PicturesToJudge = 20;

/** Draws with fewer pixels and coarser shadows where the graphics are slow. It never returns to more: a change would show. */
export class Quality {
  private readonly _stage: Stage;
  private _level = 0;
  private _slow = 0;

  constructor(stage: Stage) {
    this._stage = stage;
  }

  /** Judges the time between two pictures in a row, in milliseconds. */
  judge(step: number): void {
    if (step > TooSlow)
      this._slow++;
    else
      this._slow = Math.max(0, this._slow - 2);
    if (this._slow < PicturesToJudge || this._level === Levels.length - 1)
      return;

    this._slow = 0;
    const level = Levels[++this._level];
    this._stage.setQuality(level.pixels, level.shadows);
  }
}
