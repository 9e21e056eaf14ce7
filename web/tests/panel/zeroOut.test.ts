import assert from "node:assert/strict";
import { test } from "node:test";
import type { Status } from "../../src/live/messages";
import type { Keys } from "../../src/page/keys";
import type { Page, Takes } from "../../src/page/page";
import type { SettingsStore } from "../../src/page/settings";
import { Recorder } from "../../src/panel/recorder";
import { isConnected } from "../../src/panel/situation";
import { ZeroOut } from "../../src/panel/zeroOut";
import type { CameraRig } from "../../src/scene/cameraRig";
import { addCameraKeys, type Views } from "../../src/scene/views";
import { FakeElement, setElements } from "../elements";

function status(state: string): Status {
  return { state, words: "", advice: "", address: "", performers: [], bytesPerSecond: 0, reconnects: 0 };
}

test("a source is zeroed out only while it is connected and takes commands", () => {
  setElements();
  const page = { keys: { add: () => {} } };
  const zeroOut = new ZeroOut(page as unknown as Page);
  const { button } = zeroOut;
  assert.ok(button.disabled);
  for (const state of ["connected", "receiving", "silent"]) {
    zeroOut.allow(true, isConnected(status(state)));
    assert.ok(!button.disabled, state);
    assert.match(button.title, /\(z\)$/);
  }

  for (const state of ["created", "connecting", "waiting", "stopped"]) {
    zeroOut.allow(true, isConnected(status(state)));
    assert.ok(button.disabled, state);
    assert.equal(button.title, "The source is not connected.");
  }

  zeroOut.allow(true, isConnected(null));
  assert.ok(button.disabled);
  zeroOut.allow(false, true);
  assert.ok(button.disabled);
  assert.equal(button.title, "This source takes no commands.");
});

test("the keys say in a few words what they do", () => {
  setElements();
  const words: string[] = [];
  const keys = { add: ({ does }: { does: string }) => words.push(does) };
  new ZeroOut({ keys } as unknown as Page);
  new Recorder({ keys } as unknown as Page, {} as Takes, new FakeElement("section") as unknown as HTMLElement);
  addCameraKeys(keys as unknown as Keys, {} as CameraRig, {} as Views, {} as SettingsStore);
  assert.deepEqual([...words.slice(0, 2), words.at(-1)], ["Zero out (asks first)", "Start or stop recording", "Fit all performers"]);
});
