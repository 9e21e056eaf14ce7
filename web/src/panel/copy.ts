import { element } from "../page/dom";

/** Puts a text on the clipboard. Returns whether the browser allows it. `place` holds the focus, such as an open dialog. */
export async function copyText(text: string, place: HTMLElement): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copyBySelection(text, place);
  }
}

// Browsers have no navigator.clipboard on pages of other computers without TLS.
function copyBySelection(text: string, place: HTMLElement): boolean {
  const before = document.activeElement as HTMLElement | null;
  const area = element("textarea", { class: "unseen", "aria-hidden": "true", readonly: "" });
  area.value = text;
  place.append(area);
  area.select();
  const done = document.execCommand("copy");
  area.remove();
  before?.focus();
  return done;
}
