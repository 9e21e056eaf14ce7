import type { Api } from "../page/api";

/** The newest live pose of a character. */
export class LiveMotion {
  private readonly _socket: WebSocket;
  private _newest: DataView | null = null;
  private _isClosed = false;

  /** @param ended Called when the server ends the connection. */
  constructor(api: Api, id: number, ended: () => void) {
    const socket = api.socket(`characters/${id}/motion`);
    socket.binaryType = "arraybuffer";
    socket.addEventListener("message", event => {
      this._newest = new DataView(event.data as ArrayBuffer);
    });
    socket.addEventListener("close", () => {
      if (!this._isClosed)
        ended();
    });
    this._socket = socket;
  }

  /** The pose since the last call, or null. */
  take(): DataView | null {
    const newest = this._newest;
    this._newest = null;
    return newest;
  }

  close(): void {
    this._isClosed = true;
    this._socket.close();
  }
}
