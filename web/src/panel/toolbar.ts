import { element } from "../page/dom";
import type { Keys, Shortcut } from "../page/keys";
import type { Settings, SettingsStore } from "../page/settings";
import type { View, Views } from "../scene/views";
import { iconButton, setPressed } from "./buttons";
import type { IconName } from "./icons";
import { addToolbarKeys } from "./toolbarKeys";

type Choice = "axes" | "trails" | "contacts" | "names" | "mirror" | "follow";

const ViewButtons: readonly (readonly [View, IconName, string, string])[] = [
  ["orbit", "orbit", "Perspective view", "1"],
  ["front", "front", "Front view", "2"],
  ["side", "side", "Left side view", "3"],
  ["top", "top", "Top view", "4"],
];

const Choices: readonly (readonly [Choice, IconName, string, string])[] = [
  ["axes", "axes", "Axes of the joints", "a"],
  ["trails", "trails", "Trails of hands and feet", "t"],
  ["contacts", "contacts", "Foot contacts", "c"],
  ["names", "names", "Names", "n"],
  ["mirror", "mirror", "Mirrored view", "m"],
];

/** The tools at the edge of the stage: views, and what is shown. */
export function createToolbar(bar: HTMLElement, settings: SettingsStore, views: Views, keys: Keys): void {
  const viewButtons = ViewButtons.map(([view, icon, words, key]) => {
    keys.add(shortcut(key, words, "Camera", () => views.show(view)));
    return iconButton(icon, words, key, () => views.show(view));
  });
  const follow = toggle("follow", "follow", "Follow the performers", "f", "Camera");
  bar.append(group("Camera", ...viewButtons, follow));

  const setLook = (look: Settings["look"]): void => settings.change({ look });
  const figure = iconButton("figure", "Figure", "b", () => setLook("figure"));
  const sticks = iconButton("sticks", "Sticks", "b", () => setLook("sticks"));
  keys.add(shortcut("b", "Figure or sticks", "Stage", () => setLook(settings.now.look === "figure" ? "sticks" : "figure")));
  bar.append(group("Body", figure, sticks));

  const choices = Choices.map(([name, icon, words, key]) => toggle(name, icon, words, key, "Stage"));
  bar.append(group("Show", ...choices));

  addToolbarKeys(bar);
  views.onChange(() => showView());
  settings.watch(now => {
    setPressed(follow, now.follow);
    setPressed(figure, now.look === "figure");
    setPressed(sticks, now.look === "sticks");
    choices.forEach((button, i) => setPressed(button, now[Choices[i][0]]));
  });
  showView();

  function showView(): void {
    viewButtons.forEach((button, i) => setPressed(button, ViewButtons[i][0] === views.view));
  }

  function toggle(name: Choice, icon: IconName, words: string, key: string, group: string): HTMLButtonElement {
    keys.add(shortcut(key, words, group, () => settings.toggle(name)));
    return iconButton(icon, words, key, () => settings.toggle(name));
  }
}

function group(words: string, ...buttons: readonly HTMLElement[]): HTMLElement {
  return element("div", { class: "tools", role: "group", "aria-label": words }, ...buttons);
}

function shortcut(key: string, does: string, group: string, run: () => void): Shortcut {
  return { key, does, group, run };
}
