import { ChunkCache, type Chunk } from "./chunkCache";
import type { TakePerformerInfo } from "./info";

/** The last place in an ascending list whose value is not greater than `value`; -1 if there is none. Allocates nothing. */
export function findLast(list: ArrayLike<number>, value: number): number {
  let low = 0;
  let high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle] <= value)
      low = middle + 1;
    else
      high = middle;
  }

  return low - 1;
}

/** The frames of one performer, found by time. */
export class Track {
  info: TakePerformerInfo;
  readonly cache: ChunkCache;
  /** Frames in a chunk. */
  private _step: number;
  private _starts: Float64Array;

  constructor(info: TakePerformerInfo, load: (from: number, count: number) => Promise<ArrayBuffer>, most?: number) {
    this.info = info;
    this._step = 64;
    this._starts = new Float64Array(0);
    this.cache = new ChunkCache(chunk => load(chunk * this._step, this._step), most);
  }

  /** The server knows more frames. `starts` are the times of the first frame of every chunk. */
  update(info: TakePerformerInfo, step: number, starts: readonly number[]): void {
    this.info = info;
    this._step = step;
    this._starts = Float64Array.from(starts);
    this.cache.grow(Math.ceil(info.frames / step));
  }

  /** Number of the frame that is shown at a time: -1 if its chunk is not loaded, or if there is none. Loads what is missing. */
  frameAt(time: number, direction: number): number {
    if (this.info.frames === 0 || this._starts.length === 0)
      return -1;

    const index = Math.max(0, findLast(this._starts, time));
    this.cache.moveTo(index, direction);
    const chunk = this.cache.get(index);
    if (!chunk || chunk.times.length === 0)
      return -1;

    return index * this._step + Math.max(0, findLast(chunk.times, time));
  }

  /** The pose of a frame, if it is loaded. */
  pose(frame: number): DataView | null {
    return this._chunkOf(frame)?.poses[frame % this._step] ?? null;
  }

  /** The time of a frame, if it is loaded; otherwise NaN. */
  timeOf(frame: number): number {
    return this._chunkOf(frame)?.times[frame % this._step] ?? NaN;
  }

  private _chunkOf(frame: number): Chunk | undefined {
    return frame < 0 ? undefined : this.cache.get(Math.floor(frame / this._step));
  }
}
