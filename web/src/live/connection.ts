import { type Api, ApiError } from "../page/api";
import { ServerClock, unixNow } from "./clock";
import type { Hello, ServerMessage } from "./messages";

/** How the page stands with the program: `hidden` while the tab is in the background. */
export type ConnectionState = "connecting" | "open" | "gone" | "denied" | "hidden";

const FirstWait = 250;
const LongestWait = 3000;
const PingEvery = 2000;
// A network that vanished gives neither an answer nor an error.
const LongestAnswer = 10_000;
// About 15 s. The program tells its state every second, but a busy computer may need a while.
const MostUnanswered = 7;

/** The socket /control. Connects again by itself, and rests while the tab is hidden. It is open once the program has introduced itself. */
export class Connection {
  readonly clock = new ServerClock();
  /** What the program said last about itself. */
  hello: Hello | null = null;
  /** The sentence with which the server refused. */
  refusal = "";
  private readonly _api: Api;
  private readonly _listeners: ((message: ServerMessage) => void)[] = [];
  private readonly _stateListeners: ((state: ConnectionState) => void)[] = [];
  private readonly _openListeners: (() => void)[] = [];
  private _state: ConnectionState = "connecting";
  private _socket: WebSocket | null = null;
  private _wait = FirstWait;
  private _attempt = 0;
  private _unanswered = 0;
  private _asksFirst = false;
  private _waiting: ServerMessage[] | null = [];

  constructor(api: Api) {
    this._api = api;
    document.addEventListener("visibilitychange", () => document.hidden ? this._rest() : this.connect());
    addEventListener("online", () => this.connect());
    setInterval(() => this._ping(), PingEvery);
  }

  get state(): ConnectionState {
    return this._state;
  }

  /** Whether the program receives a stream. Otherwise it shows a file. */
  get hasStream(): boolean {
    return this.hello?.mode !== "take";
  }

  onMessage(listener: (message: ServerMessage) => void): void {
    this._listeners.push(listener);
  }

  onState(listener: (state: ConnectionState) => void): void {
    this._stateListeners.push(listener);
  }

  /** Waits until the connection is open. */
  opened(): Promise<void> {
    return this._state === "open" ? Promise.resolve() : new Promise(resolve => this._openListeners.push(resolve));
  }

  /** Gives the listeners all messages, from the first one on. Called once, when the page is complete. */
  deliver(): void {
    const waiting = this._waiting ?? [];
    this._waiting = null;
    for (const message of waiting)
      this._tell(message);
  }

  /** Connects now, unless it is connected or the tab is hidden. */
  connect(): void {
    if (document.hidden)
      this._setState("hidden");
    else if (this._socket === null)
      void this._connect(++this._attempt);
  }

  private async _connect(attempt: number): Promise<void> {
    if (this._state === "hidden")
      this._setState("connecting");
    if (!this._asksFirst) {
      this._open();
      return;
    }

    // After a failure. A WebSocket does not say why it was refused; this request does.
    try {
      await this._api.get<Hello>("hello", AbortSignal.timeout(LongestAnswer));
      if (attempt === this._attempt)
        this._open();
    } catch (error) {
      if (attempt !== this._attempt)
        return;

      const denied = error instanceof ApiError && (error.status === 401 || error.status === 403);
      this.refusal = denied ? (error as Error).message : "";
      this._setState(denied ? "denied" : "gone");
      this._retry();
    }
  }

  private _open(): void {
    const socket = this._api.socket("control");
    this._socket = socket;
    this._unanswered = 0;
    socket.addEventListener("message", event => this._receive(event.data as string));
    socket.addEventListener("close", () => this._end(socket));
  }

  private _end(socket: WebSocket): void {
    if (this._socket !== socket)
      return;

    this._socket = null;
    const needsReason = !this._asksFirst && this._state === "connecting";
    this._asksFirst = true;
    if (needsReason) {
      this.connect();
      return;
    }

    this._setState("gone");
    this._retry();
  }

  private _receive(text: string): void {
    const received = unixNow();
    this._unanswered = 0;
    const message = JSON.parse(text) as ServerMessage;
    if (message.type === "pong") {
      this.clock.add(message.t, message.time ?? message.t, received);
      return;
    }

    if (message.type === "hello")
      this._greet(message);
    if (this._waiting)
      this._waiting.push(message);
    else
      this._tell(message);
  }

  // The page of another version of the program may not understand this one.
  private _greet(hello: Hello): void {
    if (this.hello && this.hello.version !== hello.version)
      location.reload();
    this.hello = hello;
    this._asksFirst = false;
    this._wait = FirstWait;
    this._setState("open");
    this._ping();
  }

  private _tell(message: ServerMessage): void {
    for (const listener of this._listeners)
      listener(message);
  }

  // A network that vanishes closes no socket for many minutes.
  private _ping(): void {
    const socket = this._socket;
    if (socket?.readyState !== WebSocket.OPEN)
      return;

    if (this._unanswered++ < MostUnanswered) {
      socket.send(JSON.stringify({ type: "ping", t: unixNow() }));
      return;
    }

    socket.close();
    this._end(socket);
  }

  private _retry(): void {
    setTimeout(() => this.connect(), this._wait);
    this._wait = Math.min(LongestWait, this._wait * 1.6);
  }

  private _rest(): void {
    this._attempt++;
    const socket = this._socket;
    this._socket = null;
    socket?.close();
    this._wait = FirstWait;
    this._setState("hidden");
  }

  private _setState(state: ConnectionState): void {
    if (state === this._state)
      return;

    this._state = state;
    for (const listener of this._stateListeners)
      listener(state);
    for (const resolve of state === "open" ? this._openListeners.splice(0) : [])
      resolve();
  }
}
