import { element } from "../page/dom";
import type { Page } from "../page/page";
import type { TakeInfo } from "../takes/info";
import { wordButton } from "./buttons";

const Formats = [["bvh", "BVH"], ["glb", "GLB"], ["csv", "CSV"], ["nmrec", ".nmrec"]] as const;

/** A part of a take in milliseconds; null for its start or its end. */
export interface Part {
  readonly from: number | null;
  readonly to: number | null;
}

/** Buttons that save a take of the server, or a part of it, as files. */
export function downloadButtons(page: Page, take: string, name: string, part: Part = { from: null, to: null }): HTMLElement {
  const address = `takes/${encodeURIComponent(take)}`;
  return element("div", { class: "downloads", role: "group", "aria-label": `Download ${name}` }, ...Formats.map(([format, words]) => {
    const button = wordButton("download", words, () => void save());
    button.title = format === "bvh" ? "Download as BVH, a file for each performer" : `Download as ${words}`;
    return button;

    async function save(): Promise<void> {
      const range = queryOf(part);
      const base = (name.replace(/\.(bvh|nmrec|calc|bin|dat)$/i, "") || "take") + (range === "" ? "" : " part");
      button.disabled = true;
      button.classList.add("busy");
      await page.notices.attempt(() => format === "bvh" ? saveEach(base, range) : page.api.download(`${address}/download?format=${format}${range}`, `${base}.${format}`));
      button.classList.remove("busy");
      button.disabled = false;
    }

    // A BVH file holds one performer.
    async function saveEach(base: string, range: string): Promise<void> {
      const { performers } = await page.api.get<TakeInfo>(address);
      for (const { key, name: performer } of performers) {
        const file = performers.length > 1 ? `${base} ${performer || key}.bvh` : `${base}.bvh`;
        const query = performers.length > 1 ? `&performer=${encodeURIComponent(key)}` : "";
        await page.api.download(`${address}/download?format=bvh${query}${range}`, file);
      }
    }
  }));
}

/** The words of a request that name a part; empty for a whole take. */
export function queryOf(part: Part): string {
  return [["from", part.from], ["to", part.to]].map(([name, time]) => time === null ? "" : `&${name}=${time}`).join("");
}
