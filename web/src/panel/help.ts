import { element } from "../page/dom";
import type { Keys, Shortcut } from "../page/keys";
import { openDialog } from "./dialog";

const MouseHints: readonly (readonly [string, string])[] = [
  ["Drag", "Turn the view"],
  ["Shift drag, two fingers", "Move the view"],
  ["Wheel, pinch", "Closer or farther"],
  ["Drop a file", "Open a take or a character"],
];

/** Shows all keys in a dialog. */
export function showHelp(keys: Keys): void {
  const groups = new Map<string, Shortcut[]>();
  for (const shortcut of keys.all)
    groups.set(shortcut.group, [...groups.get(shortcut.group) ?? [], shortcut]);

  const lists = [...groups].map(([name, shortcuts]) =>
    list(name, shortcuts.map(shortcut => [shortcut.label ?? shortcut.key, shortcut.does] as const)));
  const licences = element("p", { class: "fine" }, "This page contains free software. ",
    element("a", { href: "licenses.txt", target: "_blank", rel: "noopener" }, "Licences"));
  openDialog("Keys", element("div", { class: "keys" }, list("Mouse and touch", MouseHints), ...lists), licences);
}

function list(name: string, rows: readonly (readonly [string, string])[]): HTMLElement {
  const terms = element("dl");
  for (const [key, does] of rows) {
    const keys = key.split(", ").flatMap((part, i) => i === 0 ? [element("kbd", {}, part)] : [" ", element("kbd", {}, part)]);
    terms.append(element("div", {}, element("dt", {}, ...keys), element("dd", {}, does)));
  }

  return element("section", {}, element("h3", {}, name), terms);
}
