import type { Api } from "../page/api";
import type { Performer } from "../scene/performer";
import type { Performers } from "../scene/performers";
import { unixNow } from "./clock";
import type { Connection } from "./connection";
import type { Contact, PerformerInfo } from "./messages";
import { avatarOf, decodePose, Pose } from "./pose";

const RetryAfter = 500;

/** The live motion of the server: of each performer, the newest pose goes on the stage once a picture. */
export class LiveFeed {
  /** Messages and bytes since the page was opened. */
  received = 0;
  receivedBytes = 0;
  /** Milliseconds from the arrival of the newest shown pose at the server until its picture was drawn, or NaN. */
  delay = NaN;
  private _shown = -Infinity;
  private readonly _api: Api;
  private readonly _connection: Connection;
  private readonly _performers: Performers;
  private readonly _known = new Map<string, PerformerInfo>();
  // The server tells them only when they change.
  private readonly _contacts = new Map<string, Contact>();
  private readonly _newest = new Map<number, DataView>();
  private readonly _pose = new Pose();
  private readonly _listeners: (() => void)[] = [];
  private _socket: WebSocket | null = null;
  private _paused = false;

  constructor(api: Api, connection: Connection, performers: Performers) {
    this._api = api;
    this._connection = connection;
    this._performers = performers;
    connection.onState(() => this._adjust());
    connection.onMessage(message => {
      if (message.type === "hello")
        this._reset(message.performers);
      else if (message.type === "performer")
        this._put(message);
      else if (message.type === "gone")
        this._remove(message.key);
      else if (message.type === "contact")
        this._touch(message);
    });
    this._adjust();
  }

  /** True while a take is shown instead. */
  get paused(): boolean {
    return this._paused;
  }

  /** Closes the motion and removes the live performers: a take is shown. */
  pause(): void {
    if (this._paused)
      return;

    this._paused = true;
    this._performers.clear();
    this._adjust();
    this._tell();
  }

  /** Shows live motion again. */
  resume(): void {
    if (!this._paused)
      return;

    this._paused = false;
    this._performers.clear();
    for (const info of this._known.values())
      this._show(info);
    this._adjust();
    this._tell();
  }

  /** Calls a function when the motion is paused or goes on. */
  onChange(listener: () => void): void {
    this._listeners.push(listener);
  }

  /** Puts the newest poses on the stage. Called once a picture. */
  update(): void {
    if (this._newest.size === 0)
      return;

    const now = unixNow();
    for (const [avatar, view] of this._newest) {
      const performer: Performer | undefined = this._performers.withIndex(avatar);
      if (!performer || !decodePose(view, this._pose))
        continue;

      performer.show(this._pose);
      this._connection.clock.arrived(this._pose.time, now);
      this._shown = Math.max(this._shown, this._pose.time);
    }

    this._newest.clear();
  }

  /** Call it after the picture with the newest poses was drawn. */
  drawn(): void {
    if (this._shown === -Infinity)
      return;

    this.delay = unixNow() + this._connection.clock.offset - this._shown;
    this._shown = -Infinity;
  }

  // Open only while somebody looks at live motion.
  private _adjust(): void {
    const isWanted = this._connection.state === "open" && !this._paused && this._connection.hasStream;
    if (isWanted && !this._socket) {
      this._open();
    } else if (!isWanted && this._socket) {
      const socket = this._socket;
      this._socket = null;
      socket.close();
      this._newest.clear();
    }
  }

  private _open(): void {
    const socket = this._api.socket("motion", "pose");
    socket.binaryType = "arraybuffer";
    this._socket = socket;
    socket.addEventListener("message", event => {
      const view = new DataView(event.data as ArrayBuffer);
      this.received++;
      this.receivedBytes += view.byteLength;
      const avatar = avatarOf(view);
      if (avatar >= 0 && this._socket === socket)
        this._newest.set(avatar, view);
    });
    socket.addEventListener("close", () => {
      if (this._socket !== socket)
        return;

      this._socket = null;
      setTimeout(() => this._adjust(), RetryAfter);
    });
  }

  // After a reconnection, performers that are still there stay as they are.
  private _reset(infos: readonly PerformerInfo[]): void {
    const keys = new Set(infos.map(info => info.key));
    for (const key of [...this._known.keys()]) {
      if (!keys.has(key))
        this._remove(key);
    }

    infos.forEach(info => this._put(info));
  }

  private _put(message: PerformerInfo): void {
    const { key, name, index, colour, variant, bones } = message;
    const info = { key, name, index, colour, variant, bones };
    this._known.set(key, info);
    if (!this._paused)
      this._show(info);
  }

  private _show(info: PerformerInfo): void {
    const { left, right } = this._contacts.get(info.key) ?? { left: false, right: false };
    this._performers.put(info).setContacts(left, right);
  }

  private _touch(contact: Contact): void {
    this._contacts.set(contact.key, contact);
    if (!this._paused)
      this._performers.get(contact.key)?.setContacts(contact.left, contact.right);
  }

  private _remove(key: string): void {
    this._known.delete(key);
    this._contacts.delete(key);
    if (!this._paused)
      this._performers.remove(key);
  }

  private _tell(): void {
    for (const listener of this._listeners)
      listener();
  }
}
