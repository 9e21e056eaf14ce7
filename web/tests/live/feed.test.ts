import assert from "node:assert/strict";
import { test } from "node:test";
import { ServerClock, unixNow } from "../../src/live/clock";
import type { Connection, ConnectionState } from "../../src/live/connection";
import { LiveFeed } from "../../src/live/feed";
import type { ServerMessage } from "../../src/live/messages";
import type { Pose } from "../../src/live/pose";
import type { Api } from "../../src/page/api";
import type { Performers } from "../../src/scene/performers";
import { performer } from "../performers";

class FakeSocket extends EventTarget {
  isClosed = false;

  close(): void {
    this.isClosed = true;
  }
}

// A feed whose connection and stage are written by the test.
function createFeed() {
  const sockets: FakeSocket[] = [];
  const shown: string[] = [];
  const onStage = new Set<string>();
  const onGround = new Map<string, [boolean, boolean]>();
  let tellState = (_: ConnectionState): void => {};
  let tell = (_: ServerMessage): void => {};
  const connection = {
    state: "connecting" as ConnectionState,
    clock: new ServerClock(),
    hasStream: true,
    onState: (listener: typeof tellState) => { tellState = listener; },
    onMessage: (listener: typeof tell) => { tell = listener; },
  };
  const performers = {
    put: ({ key }: { key: string }) => {
      onStage.add(key);
      return performers.get(key);
    },
    remove: (key: string) => onStage.delete(key),
    clear: () => {
      onStage.clear();
      onGround.clear();
    },
    get: (key: string) => ({ setContacts: (left: boolean, right: boolean) => onGround.set(key, [left, right]) }),
    withIndex: (index: number) => onStage.has(`0-${index}`) ? { show: (pose: Pose) => shown.push(`${index}:${pose.frame}`) } : undefined,
  };
  const api = { socket: () => sockets[sockets.push(new FakeSocket()) - 1] };
  const feed = new LiveFeed(api as unknown as Api, connection as unknown as Connection, performers as unknown as Performers);
  return {
    feed, sockets, shown, onStage, onGround,
    say: (message: ServerMessage) => tell(message),
    become: (state: ConnectionState) => {
      connection.state = state;
      tellState(state);
    },
    receive: (avatar: number, frame: number, time = 0) => sockets.at(-1)!.dispatchEvent(new MessageEvent("message", { data: pose(avatar, frame, time) })),
  };
}

function pose(avatar: number, frame: number, time: number): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(386));
  view.setUint8(0, 1);
  view.setUint8(1, 1);
  view.setInt32(4, avatar, true);
  view.setUint32(8, time * 1000 % 4294967296, true);
  view.setInt32(12, Math.floor(time * 1000 / 4294967296), true);
  view.setUint32(16, frame, true);
  return view.buffer;
}

function add(index: number): ServerMessage {
  return { type: "performer", ...performer(`0-${index}`), index };
}

test("of several poses before a picture, only the newest of each performer is shown", () => {
  const { feed, shown, say, become, receive } = createFeed();
  become("open");
  say(add(0));
  say(add(1));
  receive(0, 1);
  receive(1, 7);
  receive(0, 2);
  receive(0, 3);
  feed.update();
  feed.update();
  assert.deepEqual(shown, ["0:3", "1:7"]);
  assert.equal(feed.received, 4);
});

test("poses of unknown performers are ignored", () => {
  const { feed, shown, become, receive } = createFeed();
  become("open");
  receive(5, 1);
  feed.update();
  assert.deepEqual(shown, []);
});

test("motion is received only while the page is connected and no take is shown", () => {
  const { feed, sockets, onStage, say, become } = createFeed();
  assert.equal(sockets.length, 0);
  become("open");
  say(add(0));
  assert.equal(sockets.length, 1);
  become("hidden");
  assert.ok(sockets[0].isClosed);
  become("open");
  assert.equal(sockets.length, 2);

  feed.pause();
  assert.ok(sockets[1].isClosed);
  assert.equal(onStage.size, 0);
  say(add(1));
  feed.resume();
  assert.equal(sockets.length, 3);
  assert.deepEqual([...onStage], ["0-0", "0-1"]);
});

test("after a reconnection, performers that have left are gone", () => {
  const { onStage, say, become } = createFeed();
  become("open");
  say(add(0));
  say(add(1));
  const stays = { ...performer("0-1"), index: 1 };
  say({ type: "hello", name: "", version: "", mode: "live", source: "", canCommand: false, performers: [stays] });
  assert.deepEqual([...onStage], ["0-1"]);
});

test("feet that touch the ground do so after a take and with another name", () => {
  const { feed, onGround, say, become } = createFeed();
  become("open");
  say(add(0));
  say({ type: "contact", key: "0-0", left: true, right: false });
  onGround.clear();
  say({ ...add(0), name: "Anna" } as ServerMessage);
  assert.deepEqual(onGround.get("0-0"), [true, false]);

  feed.pause();
  say({ type: "contact", key: "0-0", left: true, right: true });
  assert.equal(onGround.size, 0);
  feed.resume();
  assert.deepEqual(onGround.get("0-0"), [true, true]);
});

test("the delay lasts until the picture is drawn, and is never negative", async () => {
  const { feed, say, become, receive } = createFeed();
  become("open");
  say(add(0));
  receive(0, 1, unixNow());
  feed.update();
  assert.ok(Number.isNaN(feed.delay));
  await new Promise(resolve => setTimeout(resolve, 20));
  feed.drawn();
  assert.ok(feed.delay >= 19, `${feed.delay}`);

  // The clock of the server is ahead, and no ping has told so.
  receive(0, 2, unixNow() + 5000);
  feed.update();
  feed.drawn();
  assert.ok(feed.delay >= 0, `${feed.delay}`);
  feed.delay = NaN;
  feed.drawn();
  assert.ok(Number.isNaN(feed.delay));
});
