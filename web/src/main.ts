import { createCharacters } from "./characters/characters";
import { LiveFeed } from "./live/feed";
import { api, connection } from "./live/program";
import { NoAnswer } from "./page/api";
import { element } from "./page/dom";
import { Drops } from "./page/drops";
import { Keys } from "./page/keys";
import { Loop } from "./page/loop";
import { Notices } from "./page/notices";
import type { Page } from "./page/page";
import { SettingsStore } from "./page/settings";
import { createSlots } from "./page/slots";
import { installTestHook } from "./page/testHook";
import { watchTheme } from "./page/theme";
import { Panel } from "./panel/panel";
import { CameraRig } from "./scene/cameraRig";
import { Labels } from "./scene/labels";
import { Performers } from "./scene/performers";
import { connectPointer } from "./scene/pointer";
import { Quality } from "./scene/quality";
import { Stage } from "./scene/stage";
import { addCameraKeys, Views } from "./scene/views";
import { warmUp } from "./scene/warmUp";
import { createTakes } from "./takes/takes";

const slots = createSlots();
const notices = new Notices(slots.stage.appendChild(element("div", { class: "notices", role: "status", "aria-live": "polite" })));
const settings = new SettingsStore();
let resized = false;
const stage = new Stage(slots.stage, () => {
  resized = true;
  loop.invalidate();
});
const loop = new Loop(() => {
  stage.draw();
  page.feed.drawn();
});
const performers = new Performers(stage, key => api.bytes(figureAddress(key)));
const page: Page = {
  api,
  loop,
  stage,
  performers,
  connection,
  feed: new LiveFeed(api, connection, performers),
  settings,
  notices,
  keys: new Keys(),
  drops: new Drops(document.body, text => notices.problem(text)),
  slots,
};

connection.onState(state => {
  if (state === "open")
    notices.withdraw(NoAnswer);
});

const rig = new CameraRig(stage.camera);
const views = new Views(rig, performers, stage);
const quality = new Quality(stage);
warmUp(stage);
const labels = new Labels(slots.stage, performers, stage);
connectPointer(stage.canvas, rig, () => settings.now.mirror, () => views.turned());
addCameraKeys(page.keys, rig, views, settings);

loop.add("motion", () => page.feed.update());
let posed = false;
loop.add("scene", (_, step) => {
  posed = performers.update(settings.now, step);
});
loop.add("camera", (_, step) => {
  views.update(settings.now.follow);
  const moved = rig.update(step);
  if (posed || moved)
    quality.judge(step);
  if (posed || moved || resized) {
    resized = false;
    labels.update(settings.now.names, settings.now.mirror);
    loop.invalidate();
  }
});

performers.onChange(() => loop.invalidate());

const takes = createTakes(page);
const characters = createCharacters(page, takes);
const panel = new Panel(page, connection, takes, settings, views);

watchTheme(settings, dark => stage.paint(dark));
settings.watch(now => {
  stage.canvas.classList.toggle("mirrored", now.mirror);
  performers.refresh();
  loop.invalidate();
});
installTestHook(page, connection, panel, takes, characters);
connection.deliver();

function figureAddress(key: string): string {
  const name = encodeURIComponent(key);
  return takes.current === null ? `performers/${name}/figure.glb` : `takes/${encodeURIComponent(takes.current)}/performers/${name}/figure.glb`;
}
