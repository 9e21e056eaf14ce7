import { element } from "../page/dom";
import type { Page } from "../page/page";
import { wordButton } from "./buttons";

const Formats = [["bvh", "BVH"], ["glb", "GLB"], ["csv", "CSV"], ["nmrec", ".nmrec"]] as const;

/** Buttons that save a take of the server as files. */
export function downloadButtons(page: Page, take: string, name: string): HTMLElement {
  const base = name.replace(/\.(bvh|nmrec|calc)$/i, "") || "take";
  return element("div", { class: "downloads", role: "group", "aria-label": `Download ${name}` }, ...Formats.map(([format, words]) => {
    const button = wordButton("download", words, () => void save());
    button.title = `Download as ${words}`;
    return button;

    async function save(): Promise<void> {
      button.disabled = true;
      await page.notices.attempt(() =>
        page.api.download(`takes/${encodeURIComponent(take)}/download?format=${format}`, `${base}.${format}`));
      button.disabled = false;
    }
  }));
}
