import { element } from "../page/dom";
import { icon, type IconName } from "./icons";

/** A button with an icon and a tooltip. `words` are its name for screen readers. */
export function iconButton(name: IconName, words: string, key: string, run: () => void): HTMLButtonElement {
  const title = key === "" ? words : `${words} (${key})`;
  const button = element("button", { type: "button", class: "icon-button", "aria-label": words, title }, icon(name));
  button.addEventListener("click", run);
  return button;
}

/** A button with words, and an icon before them. */
export function wordButton(name: IconName, words: string, run: () => void): HTMLButtonElement {
  const button = element("button", { type: "button", class: "button" }, icon(name), element("span", {}, words));
  button.addEventListener("click", run);
  return button;
}

/** Shows a button as pressed or not. */
export function setPressed(button: Element, pressed: boolean): void {
  button.setAttribute("aria-pressed", String(pressed));
}
