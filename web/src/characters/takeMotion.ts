import type { Api } from "../page/api";
import { timeOf } from "./pose";

/** Blocks of frames that are kept. */
const MostBlocks = 48;

/** A part of a take that is still read grows. */
const RefreshAfter = 1000;

interface Times {
  /** Frames from one time to the next. */
  readonly step: number;
  /** Milliseconds of every frame number that is a multiple of the step. */
  readonly times: readonly number[];
  /** Whether the whole file was read. Until then, poses can lack contacts of the feet. */
  readonly isComplete: boolean;
}

interface Block {
  poses: readonly DataView[];
  asked: number;
  isWaiting: boolean;
  isFinal: boolean;
}

/** The poses of a character in a take: blocks around the time that is shown, read ahead. */
export class TakeMotion {
  /** The pose after the one that was taken, if it is here. */
  next: DataView | null = null;
  /** How far the time is on its way to the next pose, 0 to 1. */
  part = 0;
  private readonly _blocks = new Map<number, Block>();
  private readonly _api: Api;
  private readonly _path: string;
  private readonly _timesPath: string;
  private readonly _now: () => number;
  private _times: Times | null = null;
  private _timesAsked = -Infinity;
  private _shown: DataView | null = null;
  private readonly _abort = new AbortController();

  constructor(api: Api, take: string, performer: string, character: number, now: () => number = () => performance.now()) {
    this._api = api;
    const address = `takes/${encodeURIComponent(take)}`;
    const who = `performer=${encodeURIComponent(performer)}`;
    this._path = `${address}/characters/${character}/poses?${who}`;
    this._timesPath = `${address}/times?${who}`;
    this._now = now;
  }

  /** The pose at a time in milliseconds: that of the last frame at or before it. Null while it is not here, and if nothing has changed. */
  take(time: number): DataView | null {
    const last = this._times ? this._times.times[this._times.times.length - 1] : undefined;
    if (last === undefined || time >= last || !this._times!.isComplete)
      this._refreshTimes();
    if (!this._times || this._times.times.length === 0)
      return null;

    const number = findLast(this._times.times.length, i => this._times!.times[i], time);
    const block = this._need(number, time);
    if (number + 1 < this._times.times.length)
      this._need(number + 1, -Infinity);

    const { poses } = block;
    const pose = poses.length > 0 ? poses[findLast(poses.length, i => timeOf(poses[i]), time)] : null;
    return pose !== null && this._moves(pose, number, time) ? pose : null;
  }

  // Between two frames, the time is that of a performer whose poses are blended. At gaps, it is that of a frame.
  private _moves(pose: DataView, number: number, time: number): boolean {
    const { poses } = this._blocks.get(number)!;
    this.next = poses[poses.indexOf(pose) + 1] ?? this._blocks.get(number + 1)?.poses[0] ?? null;
    const before = this.part;
    const from = timeOf(pose);
    this.part = this.next && time > from ? Math.min(1, (time - from) / (timeOf(this.next) - from)) : 0;
    const moves = pose !== this._shown || this.part !== before;
    this._shown = pose;
    return moves;
  }

  close(): void {
    this._abort.abort();
    this._blocks.clear();
  }

  // The newest block is the last in the map.
  private _need(number: number, time: number): Block {
    const block = this._blocks.get(number) ?? { poses: [], asked: -Infinity, isWaiting: false, isFinal: false };
    this._blocks.delete(number);
    this._blocks.set(number, block);
    if (this._blocks.size > MostBlocks)
      this._blocks.delete(this._blocks.keys().next().value!);

    const count = block.poses.length;
    const isShort = count < this._times!.step && (count === 0 || time > timeOf(block.poses[count - 1]));
    const isOld = this._times!.isComplete && !block.isFinal;
    if ((isShort || isOld) && !block.isWaiting && this._now() - block.asked > RefreshAfter)
      void this._load(number, block);
    return block;
  }

  private async _load(number: number, block: Block): Promise<void> {
    block.isWaiting = true;
    block.asked = this._now();
    const { step, isComplete } = this._times!;
    try {
      block.poses = split(await this._api.bytes(`${this._path}&from=${number * step}&count=${step}`, this._abort.signal));
      block.isFinal = isComplete;
    } catch {
      // The next picture asks again.
    }

    block.isWaiting = false;
  }

  private _refreshTimes(): void {
    if (this._now() - this._timesAsked <= RefreshAfter)
      return;

    this._timesAsked = this._now();
    this._api.get<Times>(this._timesPath, this._abort.signal).then(times => {
      this._times = times;
    }, () => {});
  }
}

/** Cuts an answer of the server into its poses. */
export function split(answer: ArrayBuffer): DataView[] {
  const whole = new DataView(answer);
  const poses: DataView[] = [];
  for (let at = 0; at + 4 <= answer.byteLength;) {
    const size = whole.getUint32(at, true);
    if (at + 4 + size > answer.byteLength)
      break;

    poses.push(new DataView(answer, at + 4, size));
    at += 4 + size;
  }

  return poses;
}

/** The last of some increasing values that is at most a limit; 0 if there is none. */
export function findLast(count: number, value: (index: number) => number, limit: number): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (value(middle) <= limit)
      low = middle + 1;
    else
      high = middle;
  }

  return Math.max(0, low - 1);
}
