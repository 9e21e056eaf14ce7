const Samples = 16;

/** How far the server's clock is ahead of this computer's, from the answers to pings. */
export class ServerClock {
  private readonly _offsets: number[] = [];
  private readonly _trips: number[] = [];
  private _offset = 0;

  /** Milliseconds to add to this computer's clock. */
  get offset(): number {
    return this._offset;
  }

  /** Adds an answer. All three are Unix milliseconds. The fastest of the last answers decides. */
  add(sent: number, server: number, received: number): void {
    this._offsets.push(server - (sent + received) / 2);
    this._trips.push(received - sent);
    if (this._offsets.length > Samples) {
      this._offsets.shift();
      this._trips.shift();
    }

    this._offset = this._offsets[this._trips.indexOf(Math.min(...this._trips))];
  }

  /** Notes the arrival of a message. It cannot have arrived before the server sent it. */
  arrived(server: number, received: number): void {
    this._offset = Math.max(this._offset, server - received);
  }
}

/** The clock of this computer in Unix milliseconds, with fractions. It does not jump. */
export function unixNow(): number {
  return performance.timeOrigin + performance.now();
}
