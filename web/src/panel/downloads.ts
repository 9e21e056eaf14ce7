import { element } from "../page/dom";
import type { Page } from "../page/page";
import type { TakeInfo } from "../takes/info";
import { wordButton } from "./buttons";

const Words = { bvh: "BVH", glb: "GLB", csv: "CSV", nmrec: ".nmrec" } as const;

export type Format = keyof typeof Words;

const AllFormats = Object.keys(Words) as Format[];

/** A part of a take in milliseconds; null for its start or its end. */
export interface Part {
  readonly from: number | null;
  readonly to: number | null;
}

export const Whole: Part = { from: null, to: null };

/** Buttons that save a take of the server, or a part of it, as files. */
export function downloadButtons(page: Page, take: string, name: string, part: Part = Whole, formats: readonly Format[] = AllFormats): HTMLElement {
  const address = `takes/${encodeURIComponent(take)}`;
  return element("div", { class: "downloads", role: "group", "aria-label": `Download ${name}` }, ...formats.map(format => {
    const words = Words[format];
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

    // A BVH file holds one performer. Of a take without performers, the server says why there is no file.
    async function saveEach(base: string, range: string): Promise<void> {
      const { performers } = await page.api.get<TakeInfo>(address);
      if (performers.length < 2) {
        await page.api.download(`${address}/download?format=bvh${range}`, `${base}.bvh`);
        return;
      }

      for (const { key, name: performer } of performers)
        await page.api.download(`${address}/download?format=bvh&performer=${encodeURIComponent(key)}${range}`, `${base} ${performer || key}.bvh`);
    }
  }));
}

/** The words of a request that name a part; empty for a whole take. */
export function queryOf(part: Part): string {
  return [["from", part.from], ["to", part.to]].map(([name, time]) => time === null ? "" : `&${name}=${time}`).join("");
}
