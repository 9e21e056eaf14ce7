import { createCharacters } from "./characters/characters";
import { LiveFeed } from "./live/feed";
import { Api } from "./page/api";
import { Drops } from "./page/drops";
import { element } from "./page/dom";
import { Keys } from "./page/keys";
import { Loop } from "./page/loop";
import { Notices } from "./page/notices";
import type { Page } from "./page/page";
import { createSlots } from "./page/slots";
import { Performers } from "./scene/performers";
import { Stage } from "./scene/stage";
import { createTakes } from "./takes/takes";

const slots = createSlots();
const list = element("div", { class: "notices", role: "status", "aria-live": "polite" });
slots.stage.append(list);
const notices = new Notices(list);
const stage = new Stage(slots.stage, () => loop.invalidate());
const loop = new Loop(() => stage.draw());
const page: Page = {
  api: new Api(),
  loop,
  stage,
  performers: new Performers(stage),
  feed: new LiveFeed(),
  notices,
  keys: new Keys(),
  drops: new Drops(document.body, text => notices.problem(text)),
  slots,
};
createTakes(page);
createCharacters(page);
