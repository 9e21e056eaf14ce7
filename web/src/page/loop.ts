/** Runs before or after others in a picture: poses are set first, then what follows them, then cameras. */
export type Phase = "motion" | "scene" | "camera";

/** `now` and `step` are milliseconds: the time of the picture, and the time since the one before. */
export type FrameHandler = (now: number, step: number) => void;

/** Calls handlers once a picture, and draws if something changed. Stands still while the tab is hidden. */
export class Loop {
  private readonly _handlers: Record<Phase, FrameHandler[]> = { motion: [], scene: [], camera: [] };
  private readonly _draw: () => void;
  private _last = 0;
  private _changed = true;
  /** Main-thread milliseconds of the last pictures, as a ring. */
  readonly frameTimes = new Float32Array(240);
  /** The part of them for poses and what follows them, without cameras and drawing. */
  readonly motionTimes = new Float32Array(240);
  pictures = 0;

  constructor(draw: () => void) {
    this._draw = draw;
    requestAnimationFrame(this._run);
  }

  /** Adds a handler. Returns a function that removes it. */
  add(phase: Phase, handler: FrameHandler): () => void {
    this._handlers[phase].push(handler);
    return () => {
      this._handlers[phase] = this._handlers[phase].filter(other => other !== handler);
    };
  }

  /** Says that the next picture differs from the last. Without it, nothing is drawn. */
  invalidate(): void {
    this._changed = true;
  }

  private readonly _run = (now: number): void => {
    requestAnimationFrame(this._run);
    const start = performance.now();
    const step = Math.min(250, now - this._last);
    this._last = now;
    this._call(this._handlers.motion, now, step);
    this._call(this._handlers.scene, now, step);
    const moved = performance.now();
    this._call(this._handlers.camera, now, step);
    if (!this._changed)
      return;

    this._changed = false;
    this._draw();
    const place = this.pictures++ % this.frameTimes.length;
    this.motionTimes[place] = moved - start;
    this.frameTimes[place] = performance.now() - start;
  };

  private _call(handlers: readonly FrameHandler[], now: number, step: number): void {
    for (const handler of handlers)
      handler(now, step);
  }
}
