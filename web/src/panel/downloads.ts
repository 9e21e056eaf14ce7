import { element } from "../page/dom";
import type { Page } from "../page/page";
import type { TakeInfo } from "../takes/info";
import { wordButton } from "./buttons";

const Formats = [["bvh", "BVH"], ["glb", "GLB"], ["csv", "CSV"], ["nmrec", ".nmrec"]] as const;

/** Buttons that save a take of the server as files. */
export function downloadButtons(page: Page, take: string, name: string): HTMLElement {
  const base = name.replace(/\.(bvh|nmrec|calc|bin|dat)$/i, "") || "take";
  const address = `takes/${encodeURIComponent(take)}`;
  return element("div", { class: "downloads", role: "group", "aria-label": `Download ${name}` }, ...Formats.map(([format, words]) => {
    const button = wordButton("download", words, () => void save());
    button.title = format === "bvh" ? "Download as BVH, a file for each performer" : `Download as ${words}`;
    return button;

    async function save(): Promise<void> {
      button.disabled = true;
      button.classList.add("busy");
      await page.notices.attempt(() => format === "bvh" ? saveEach() : page.api.download(`${address}/download?format=${format}`, `${base}.${format}`));
      button.classList.remove("busy");
      button.disabled = false;
    }

    // A BVH file holds one performer.
    async function saveEach(): Promise<void> {
      const { performers } = await page.api.get<TakeInfo>(address);
      for (const { key, name: performer } of performers) {
        const file = performers.length > 1 ? `${base} ${performer || key}.bvh` : `${base}.bvh`;
        const query = performers.length > 1 ? `&performer=${encodeURIComponent(key)}` : "";
        await page.api.download(`${address}/download?format=bvh${query}`, file);
      }
    }
  }));
}
