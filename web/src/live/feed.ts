/** The live motion of the server. */
export class LiveFeed {
  private _paused = false;

  /** True while a take is shown instead. */
  get paused(): boolean {
    return this._paused;
  }

  /** Closes the motion and removes the live performers: a take is shown. */
  pause(): void {
    this._paused = true;
  }

  /** Shows live motion again. */
  resume(): void {
    this._paused = false;
  }
}
