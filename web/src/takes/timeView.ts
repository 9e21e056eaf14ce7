/** The part of the time that the time line and the plot show, both with the same scale. */
export class TimeView {
  from = 0;
  to = 1;
  private _duration = 0;
  private readonly _listeners: (() => void)[] = [];

  /** Calls a function when the part changes. */
  onChange(listener: () => void): void {
    this._listeners.push(listener);
  }

  get span(): number {
    return this.to - this.from;
  }

  get isWhole(): boolean {
    return this.from <= 0 && this.to >= this._duration;
  }

  /** The take has this length. A view of the whole take stays one. */
  setDuration(duration: number): void {
    const whole = this._duration === 0 || this.isWhole;
    this._duration = duration;
    if (whole)
      this._set(0, Math.max(1, duration));
  }

  showAll(): void {
    this._set(0, Math.max(1, this._duration));
  }

  /** Shows more or less time, around a time that stays where it is. */
  zoom(factor: number, around: number): void {
    const span = Math.min(Math.max(1, this._duration), Math.max(200, this.span * factor));
    const share = (around - this.from) / this.span;
    this._move(around - share * span, span);
  }

  pan(milliseconds: number): void {
    this._move(this.from + milliseconds, this.span);
  }

  /** Moves the view so that a time is visible. */
  reveal(time: number): void {
    if (time < this.from || time > this.to)
      this._move(time - this.span * 0.1, this.span);
  }

  private _move(from: number, span: number): void {
    const start = Math.max(0, Math.min(from, Math.max(1, this._duration) - span));
    this._set(start, start + span);
  }

  private _set(from: number, to: number): void {
    if (from === this.from && to === this.to)
      return;

    this.from = from;
    this.to = to;
    for (const listener of this._listeners)
      listener();
  }
}
