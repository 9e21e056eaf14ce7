import assert from "node:assert/strict";
import { test } from "node:test";
import { Connection } from "../../src/live/connection";
import type { ServerMessage } from "../../src/live/messages";
import { type Api, ApiError } from "../../src/page/api";
import { setGlobals } from "../globals";

class FakeSocket extends EventTarget {
  static readonly OPEN = 1;
  readonly readyState = FakeSocket.OPEN;

  send(): void {}

  close(): void {}

  say(message: ServerMessage): void {
    this.dispatchEvent(new MessageEvent("message", { data: JSON.stringify(message) }));
  }
}

const hello: ServerMessage = { type: "hello", name: "", version: "1", mode: "live", source: "", canCommand: false, performers: [] };

// A connection whose program is the test. `reason` answers the request that says why a socket was refused.
function createConnection(reason: () => Promise<unknown>) {
  const sockets: FakeSocket[] = [];
  const asked: string[] = [];
  let ping = (): void => {};
  setGlobals({
    document: { hidden: false, addEventListener: () => {} },
    addEventListener: () => {},
    setInterval: (run: () => void) => {
      ping = run;
      return 0;
    },
    setTimeout: () => 0,
    WebSocket: FakeSocket,
  });
  const api = {
    socket: () => sockets[sockets.push(new FakeSocket()) - 1],
    get: (path: string) => {
      asked.push(path);
      return reason();
    },
  };
  return { connection: new Connection(api as unknown as Api), sockets, asked, ping: () => ping() };
}

const settle = () => new Promise(resolve => setImmediate(resolve));

test("the first connection needs no request, and is open when the program has introduced itself", () => {
  const { connection, sockets, asked } = createConnection(() => Promise.resolve());
  connection.connect();
  assert.equal(sockets.length, 1);
  assert.equal(connection.state, "connecting");
  sockets[0].say(hello);
  assert.equal(connection.state, "open");
  assert.deepEqual(asked, []);
});

test("what needs the program waits until the connection is open", async () => {
  const { connection, sockets } = createConnection(() => Promise.resolve());
  let runs = 0;
  const wait = () => void connection.opened().then(() => runs++);
  wait();
  connection.connect();
  await settle();
  assert.equal(runs, 0);
  sockets[0].say(hello);
  wait();
  await settle();
  assert.equal(runs, 2);
});

test("messages that come before the page is complete wait for it", () => {
  const { connection, sockets } = createConnection(() => Promise.resolve());
  const heard: string[] = [];
  connection.connect();
  sockets[0].say(hello);
  sockets[0].say({ type: "gone", key: "0-1" });
  connection.onMessage(message => heard.push(message.type));
  assert.deepEqual(heard, []);
  connection.deliver();
  sockets[0].say({ type: "problem", text: "" });
  assert.deepEqual(heard, ["hello", "gone", "problem"]);
});

test("a refused connection asks for the reason at once", async () => {
  const { connection, sockets, asked } = createConnection(() => Promise.reject(new ApiError(401, "Open the link.")));
  connection.connect();
  sockets[0].dispatchEvent(new Event("close"));
  await settle();
  assert.deepEqual(asked, ["hello"]);
  assert.equal(connection.state, "denied");
  assert.equal(connection.refusal, "Open the link.");
  assert.equal(sockets.length, 1);
});

test("a network that vanishes ends the connection, and the page connects again", async () => {
  const { connection, sockets, ping } = createConnection(() => Promise.resolve());
  connection.connect();
  sockets[0].say(hello);
  for (let i = 0; i < 20; i++) {
    ping();
    sockets[0].say({ type: "pong", t: 0, time: 0 });
  }

  assert.equal(connection.state, "open");
  for (let i = 0; i < 20 && connection.state === "open"; i++)
    ping();

  assert.equal(connection.state, "gone");
  connection.connect();
  await settle();
  assert.equal(sockets.length, 2);

  // The old socket ends at last.
  sockets[1].say(hello);
  sockets[0].dispatchEvent(new Event("close"));
  assert.equal(connection.state, "open");
});

test("after a failure, a request goes before each socket", async () => {
  const { connection, sockets, asked } = createConnection(() => Promise.resolve());
  connection.connect();
  sockets[0].say(hello);
  sockets[0].dispatchEvent(new Event("close"));
  assert.equal(connection.state, "gone");
  connection.connect();
  assert.equal(sockets.length, 1);
  await settle();
  assert.deepEqual(asked, ["hello"]);
  assert.equal(sockets.length, 2);

  // Refused although the request was answered: the page waits before it tries again.
  sockets[1].dispatchEvent(new Event("close"));
  await settle();
  assert.equal(connection.state, "gone");
  assert.equal(sockets.length, 2);
});
