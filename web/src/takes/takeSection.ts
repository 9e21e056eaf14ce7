import { element, setText } from "../page/dom";
import type { Page } from "../page/page";
import { wordButton } from "../panel/buttons";
import { downloadButtons } from "../panel/downloads";
import { KindWords, type TakeInfo } from "./info";
import type { Playback } from "./playback";
import { clock } from "./ticks";

/** The section of the panel about the take: what it is, what is wrong with it, downloads, and the way back to live motion. */
export class TakeSection {
  private readonly _page: Page;
  private readonly _playback: Playback;
  private readonly _close: () => void;
  private readonly _part = element("small");
  private _shown = "";

  constructor(page: Page, playback: Playback, close: () => void) {
    this._page = page;
    this._playback = playback;
    this._close = close;
  }

  show(info: TakeInfo): void {
    const text = JSON.stringify({ ...info, performers: info.performers.map(each => [each.key, each.frames]) });
    if (text === this._shown)
      return;

    this._shown = text;
    const place = this._page.slots.take;
    const rows: [string, string][] = [["Kind", KindWords[info.kind]], ["Duration", `${clock(info.duration)}`]];
    for (const performer of info.performers)
      rows.push([info.performers.length > 1 ? performer.name : "Frames", framesOf(performer.frames, performer.rate)]);
    place.replaceChildren(
      element("h2", {}, "Take"),
      element("p", { class: "state-line" }, element("strong", { class: "name" }, info.name)),
      element("dl", { class: "figures" }, ...rows.map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value)))));
    if (info.progress < 1)
      place.append(progressOf(info.progress));
    if (info.problems.length > 0)
      place.append(element("ul", { class: "problems", "aria-label": "Problems of the file" }, ...info.problems.map(text => element("li", {}, text))));
    if (info.performers.length > 0)
      place.append(this._part, downloadButtons(this._page, info.id, info.name, this._playback));
    this.showPart();
    if (this._page.connection.hello?.mode !== "take")
      place.append(element("div", { class: "buttons" }, wordButton("live", "Back to live", this._close)));
  }

  /** Says what a download holds: in and out points have changed. */
  showPart(): void {
    const { from, to, start, end } = this._playback;
    this._part.hidden = from === null && to === null;
    setText(this._part, `Downloads hold the part from ${clock(start)} to ${clock(end)}. For the whole take, remove the points (x).`);
  }

  clear(): void {
    this._shown = "";
    this._page.slots.take.replaceChildren();
  }
}

function framesOf(frames: number, rate: number | null): string {
  const count = frames.toLocaleString("en").replace(/,/g, " ");
  return rate === null ? `${count} frames` : `${count} at ${Math.round(rate * 100) / 100} Hz`;
}

function progressOf(part: number): HTMLElement {
  const bar = element("progress", { max: "1", value: part.toFixed(3), "aria-label": "Reading the file" });
  return element("div", { class: "reading" }, element("small", {}, `Reading the file: ${Math.floor(part * 100)} %`), bar);
}
