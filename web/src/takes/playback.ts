export const Speeds = [0.1, 0.25, 0.5, 1, 2, 4] as const;

/** Where the take is, and how it moves. Times are milliseconds. */
export class Playback {
  time = 0;
  duration = 0;
  playing = false;
  speed = 1;
  loop = true;
  /** The part that is played; null for the first frame or the end of the take. */
  from: number | null = null;
  to: number | null = null;
  /** The time of the first frame. Recordings begin before it. */
  first = 0;
  /** Called when anything but the time has changed. */
  onChange: (() => void) | null = null;

  get start(): number {
    return this.from ?? this.first;
  }

  get end(): number {
    return this.to ?? this.duration;
  }

  toggle(): void {
    this.playing = !this.playing && this.duration > 0;
    if (this.playing && (this.time >= this.end || this.time < this.start))
      this.time = this.start;
    this.onChange?.();
  }

  pause(): void {
    if (!this.playing)
      return;

    this.playing = false;
    this.onChange?.();
  }

  /** Moves to a time. */
  seek(time: number): void {
    this.time = Math.min(this.duration, Math.max(0, time));
  }

  /** Moves by the time of a picture. Returns whether the time has changed. */
  advance(milliseconds: number): boolean {
    if (!this.playing)
      return false;

    this.time += milliseconds * this.speed;
    if (this.time < this.end)
      return true;

    const length = this.end - this.start;
    if (this.loop && length > 0) {
      this.time = this.start + (this.time - this.start) % length;
    } else {
      this.time = this.end;
      this.pause();
    }

    return true;
  }

  setSpeed(speed: number): void {
    this.speed = Math.min(Speeds[Speeds.length - 1], Math.max(Speeds[0], speed));
    this.onChange?.();
  }

  /** The next speed of the list. */
  changeSpeed(direction: number): void {
    const next = direction > 0 ? Speeds.find(speed => speed > this.speed) : [...Speeds].reverse().find(speed => speed < this.speed);
    if (next !== undefined)
      this.setSpeed(next);
  }

  toggleLoop(): void {
    this.loop = !this.loop;
    this.onChange?.();
  }

  /** The part starts at a time. A part that would be empty loses its other end, or has none at all. */
  setFrom(time: number | null): void {
    this.from = time === null || time <= 0 || time >= this.duration ? null : time;
    if (this.from !== null && this.to !== null && this.to <= this.from)
      this.to = null;
    this.onChange?.();
  }

  setTo(time: number | null): void {
    this.to = time === null || time <= this.first || time >= this.duration ? null : time;
    if (this.to !== null && this.from !== null && this.from >= this.to)
      this.from = null;
    this.onChange?.();
  }

  clearPart(): void {
    this.from = null;
    this.to = null;
    this.onChange?.();
  }
}
