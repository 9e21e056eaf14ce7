/** Frames that are loaded together. */
export interface Chunk {
  readonly index: number;
  /** Time of each frame in milliseconds. */
  readonly times: Float64Array;
  readonly poses: readonly DataView[];
}

export type ChunkLoader = (chunk: number) => Promise<ArrayBuffer>;

const MostRequests = 2;
const RetryAfter = 1000;
const TimeOffset = 8;

/** Keeps the chunks around the cursor, and loads those that come next. Its memory does not depend on the length of the take. */
export class ChunkCache {
  /** Called when a chunk has arrived. */
  onLoad: (() => void) | null = null;
  /** Called when a chunk could not be loaded. If it returns false, nothing more is asked for. */
  onFail: ((error: Error) => boolean) | null = null;
  private readonly _load: ChunkLoader;
  private readonly _most: number;
  private readonly _chunks = new Map<number, Chunk>();
  private readonly _pending = new Set<number>();
  private _count = 0;
  private _cursor = 0;
  private _direction = 1;
  private _generation = 0;
  private _rests = false;
  private readonly _wait: (run: () => void) => void;

  /**
   * @param most The largest number of chunks in memory.
   * @param wait Runs something later. After a failure, nothing is asked for until then, so that a dead server is not flooded.
   */
  constructor(load: ChunkLoader, most = 64, wait: (run: () => void) => void = run => void setTimeout(run, RetryAfter)) {
    this._load = load;
    this._most = most;
    this._wait = wait;
  }

  get size(): number {
    return this._chunks.size;
  }

  /** The take has more chunks than before. The last one of before may have grown, so it is loaded again. */
  grow(count: number): void {
    if (this._count > 0)
      this.drop(this._count - 1);
    this._count = count;
  }

  /** Forgets a chunk. */
  drop(index: number): void {
    this._chunks.delete(index);
    if (this._pending.delete(index))
      this._generation++;
  }

  get(index: number): Chunk | undefined {
    return this._chunks.get(index);
  }

  /** Says where the cursor is and in which direction it moves. Loads what is missing around it. */
  moveTo(index: number, direction: number): void {
    if (direction !== 0)
      this._direction = direction;
    if (index === this._cursor && this._chunks.has(index) && this._isComplete())
      return;

    this._cursor = index;
    this._pump();
  }

  clear(): void {
    this._chunks.clear();
    this._pending.clear();
    this._count = 0;
    this._generation++;
  }

  private get _ahead(): number {
    return Math.floor(this._most / 2);
  }

  private get _behind(): number {
    return Math.floor(this._most / 8);
  }

  private _isComplete(): boolean {
    return this._next() === -1;
  }

  // The cursor's chunk first, then those ahead, then some behind.
  private _next(): number {
    for (let i = 0; i <= this._ahead; i++) {
      if (this._isMissing(this._cursor + i * this._direction))
        return this._cursor + i * this._direction;
    }

    for (let i = 1; i <= this._behind; i++) {
      if (this._isMissing(this._cursor - i * this._direction))
        return this._cursor - i * this._direction;
    }

    return -1;
  }

  private _isMissing(index: number): boolean {
    return index >= 0 && index < this._count && !this._chunks.has(index) && !this._pending.has(index);
  }

  private _pump(): void {
    while (!this._rests && this._pending.size < MostRequests) {
      const next = this._next();
      if (next < 0)
        return;

      this._pending.add(next);
      void this._fetch(next, this._generation);
    }
  }

  private async _fetch(index: number, generation: number): Promise<void> {
    let chunk: Chunk | null = null;
    let failure: Error | null = null;
    try {
      chunk = parseChunk(index, await this._load(index));
    } catch (error) {
      failure = error as Error;
    }

    if (generation !== this._generation && !this._pending.has(index))
      return;

    this._pending.delete(index);
    if (chunk) {
      this._chunks.set(index, chunk);
      this._evict();
      this.onLoad?.();
    } else {
      this._rest(failure!);
    }

    this._pump();
  }

  private _rest(failure: Error): void {
    if (this._rests)
      return;

    this._rests = true;
    if (this.onFail?.(failure) === false)
      return;

    this._wait(() => {
      this._rests = false;
      this._pump();
    });
  }

  private _evict(): void {
    while (this._chunks.size > this._most) {
      let farthest = -1;
      for (const index of this._chunks.keys()) {
        if (farthest < 0 || Math.abs(index - this._cursor) > Math.abs(farthest - this._cursor))
          farthest = index;
      }

      this._chunks.delete(farthest);
    }
  }
}

/** Reads frames that each follow their length. */
export function parseChunk(index: number, bytes: ArrayBuffer): Chunk {
  const all = new DataView(bytes);
  const poses: DataView[] = [];
  for (let place = 0; place + 4 <= bytes.byteLength;) {
    const length = all.getUint32(place, true);
    poses.push(new DataView(bytes, place + 4, length));
    place += 4 + length;
  }

  const times = Float64Array.from(poses, pose => (pose.getUint32(TimeOffset, true) + pose.getInt32(TimeOffset + 4, true) * 4294967296) / 1000);
  return { index, times, poses };
}
