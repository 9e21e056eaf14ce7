import { decodePose, Pose } from "../live/pose";
import { ApiError } from "../page/api";
import type { Page } from "../page/page";
import { isIn, type TakeContacts, type TakeInfo, toPerformer } from "./info";
import { blend } from "./blend";
import type { Playback } from "./playback";
import { Track } from "./track";

// Frames that stay longer on the screen are blended while the take plays, in milliseconds.
const LongestStill = 20;
const NotFound = 404;
// Milliseconds: times of gaps and frames are rounded to microseconds.
const SameTime = 0.01;

interface Shown {
  readonly track: Track;
  contacts: TakeContacts | null;
  /** The frame that is shown as it is; -1 for none, or a blend of two. */
  frame: number;
}

/** Puts the frames of a take on the stage. */
export class TakePlayer {
  /** Number of the first performer's frame, -1 if it is not loaded. */
  frame = -1;
  /** Whether the first performer has no frames at this time. */
  isGap = false;
  private readonly _page: Page;
  private readonly _playback: Playback;
  private readonly _pose = new Pose();
  private readonly _next = new Pose();
  private _wasPlaying = false;
  private readonly _performers: Shown[] = [];
  private readonly _base: string;
  private _time = NaN;
  private _fresh = false;
  private _isDisposed = false;

  constructor(page: Page, playback: Playback, id: string) {
    this._page = page;
    this._playback = playback;
    this._base = `takes/${encodeURIComponent(id)}`;
  }

  /** Takes what the server knows of the take now. */
  async update(info: TakeInfo): Promise<void> {
    for (let i = 0; i < info.performers.length; i++) {
      const performer = info.performers[i];
      const query = `performer=${encodeURIComponent(performer.key)}`;
      const shown = this._performers[i] ??= {
        track: new Track(performer, async (from, count) => {
          await this._page.connection.opened();
          if (this._isDisposed)
            throw new Error("The take has been left.");
          return this._page.api.bytes(`${this._base}/poses?${query}&from=${from}&count=${count}`);
        }),
        contacts: null,
        frame: -1,
      };
      shown.track.cache.onLoad = () => {
        this._fresh = true;
      };
      shown.track.cache.onFail = error => this._keepsAsking(error);
      const { step, times } = await this._page.api.get<{ step: number; times: number[] }>(`${this._base}/times?${query}`);
      if (this._isDisposed)
        return;

      shown.track.update(performer, step, times);
      this._page.performers.put(toPerformer(performer));
      this._fresh = true;
    }
  }

  async loadContacts(): Promise<readonly (TakeContacts | null)[]> {
    for (const shown of this._performers)
      shown.contacts = await this._page.api.get<TakeContacts>(`${this._base}/contacts?performer=${encodeURIComponent(shown.track.info.key)}`);
    return this._performers.map(shown => shown.contacts);
  }

  /** Whether the frames at a time are there, so that the time can go on. */
  isReady(time: number, direction: number): boolean {
    for (const shown of this._performers) {
      if (shown.track.info.frames > 0 && shown.track.frameAt(time, direction) < 0)
        return false;
    }

    return true;
  }

  /** Shows the frames of the current time. Allocates nothing. Returns whether anything may have changed. */
  show(): boolean {
    const time = this._playback.time;
    const hasStopped = this._wasPlaying && !this._playback.playing;
    this._wasPlaying = this._playback.playing;
    if (time === this._time && !this._fresh && !hasStopped)
      return false;

    const direction = time === this._time ? 0 : time < this._time ? -1 : 1;
    this._time = time;
    this._fresh = false;
    for (let i = 0; i < this._performers.length; i++)
      this._showPerformer(this._performers[i], time, direction, i === 0);
    return true;
  }

  /** The time of the frame before or after the one that is shown; null if it is not known. */
  timeOfStep(direction: number): number | null {
    const track = this._performers.find(shown => shown.track.info.frames > 0)?.track;
    if (!track)
      return null;

    const frame = track.frameAt(this._playback.time, direction);
    const next = Math.min(track.info.frames - 1, Math.max(0, frame + direction));
    const time = track.timeOf(next);
    return frame < 0 || Number.isNaN(time) ? null : time;
  }

  /** Frames of the first performer. */
  get frames(): number {
    return this._performers[0]?.track.info.frames ?? 0;
  }

  dispose(): void {
    this._isDisposed = true;
    for (const { track } of this._performers) {
      track.cache.onLoad = null;
      track.cache.onFail = null;
      track.cache.clear();
    }

    this._performers.length = 0;
  }

  private _showPerformer(shown: Shown, time: number, direction: number, isFirst: boolean): void {
    const { track } = shown;
    const frame = track.frameAt(time, direction);
    if (isFirst) {
      this.frame = frame;
      this.isGap = isInGap(track, time);
    }

    const performer = this._page.performers.get(track.info.key);
    if (!performer || frame < 0)
      return;

    if (shown.contacts)
      performer.setContacts(isIn(shown.contacts.left, time), isIn(shown.contacts.right, time));

    const part = this._playback.playing ? this._partAfter(track, frame, time) : 0;
    if (part === 0 && frame === shown.frame && performer.hasPose)
      return;

    const view = track.pose(frame);
    if (!view || !decodePose(view, this._pose))
      return;

    if (part > 0 && decodePose(track.pose(frame + 1)!, this._next))
      blend(this._pose, this._next, part);
    shown.frame = part > 0 ? -1 : frame;
    performer.show(this._pose);
  }

  // How far the time is on its way to the next frame, 0 to 1. 0 if frames follow fast enough, at a gap, or if the next frame is not there yet.
  private _partAfter(track: Track, frame: number, time: number): number {
    const from = track.timeOf(frame);
    const to = track.timeOf(frame + 1);
    const isStill = to - from > LongestStill * this._playback.speed;
    return isStill && time > from && !endsAtGap(track, from) ? Math.min(1, (time - from) / (to - from)) : 0;
  }

  // The program may be away for a moment. A take that it has closed does not come back.
  private _keepsAsking(error: Error): boolean {
    if (!(error instanceof ApiError) || error.status !== NotFound)
      return true;

    this._playback.pause();
    this._page.notices.problem(error.message);
    return false;
  }
}

// Allocates nothing.
function endsAtGap(track: Track, time: number): boolean {
  const gaps = track.info.gaps;
  for (let i = 0; i < gaps.length; i++) {
    if (Math.abs(gaps[i][0] - time) < SameTime)
      return true;
  }

  return false;
}

function isInGap(track: Track, time: number): boolean {
  const { info } = track;
  return info.frames === 0 || time > info.end + 1 || time < info.start - 1 || isInside(track, time);
}

// The frames at both ends of a gap exist.
function isInside(track: Track, time: number): boolean {
  const gaps = track.info.gaps;
  for (let i = 0; i < gaps.length; i++) {
    if (time > gaps[i][0] + 50 && time < gaps[i][1])
      return true;
  }

  return false;
}
