import { element, setText } from "../page/dom";
import type { Page } from "../page/page";
import { wordButton } from "../panel/buttons";
import { downloadButtons } from "../panel/downloads";
import type { IconName } from "../panel/icons";
import { KindWords, type TakeInfo } from "./info";
import type { Playback } from "./playback";
import { clock } from "./ticks";

/** The section of the panel about the take: what it is, what is wrong with it, downloads, and the way back. */
export class TakeSection {
  private readonly _page: Page;
  private readonly _playback: Playback;
  private readonly _back: () => void;
  private readonly _figures = element("dl", { class: "figures" });
  private readonly _share = element("small");
  private readonly _bar = element("progress", { max: "1", "aria-label": "Reading the file" });
  private readonly _reading = element("div", { class: "reading" }, this._share, this._bar);
  private readonly _problems = element("ul", { class: "problems", "aria-label": "Problems of the file" });
  private readonly _part = element("small");
  private _downloads: HTMLElement = element("div");
  private _shown: string | null = null;

  /** @param back Shows again what the program was started with. */
  constructor(page: Page, playback: Playback, back: () => void) {
    this._page = page;
    this._playback = playback;
    this._back = back;
  }

  /** Shows what the server knows of a take now. The buttons of a take stay, because one of them may have the focus. */
  show(info: TakeInfo): void {
    if (this._shown !== info.id)
      this._build(info);

    const rows: [string, string][] = [["Kind", KindWords[info.kind]], ["Duration", `${clock(info.duration)}`]];
    for (const performer of info.performers)
      rows.push([info.performers.length > 1 ? performer.name : "Frames", framesOf(performer.frames, performer.rate)]);
    this._figures.replaceChildren(...rows.map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value))));
    this._reading.hidden = info.progress >= 1;
    this._bar.value = info.progress;
    setText(this._share, `Reading the file: ${Math.floor(info.progress * 100)} %`);
    this._problems.hidden = info.problems.length === 0;
    this._problems.replaceChildren(...info.problems.map(text => element("li", {}, text)));
    this._downloads.hidden = info.performers.length === 0;
  }

  /** Says what a download holds: in and out points have changed. */
  showPart(): void {
    const { from, to, start, end } = this._playback;
    this._part.hidden = from === null && to === null;
    setText(this._part, `Downloads hold the part from ${clock(start)} to ${clock(end)}. For the whole take, remove the points (x).`);
  }

  clear(): void {
    this._shown = null;
    this._page.slots.take.replaceChildren();
  }

  private _build(info: TakeInfo): void {
    this._shown = info.id;
    this._downloads = downloadButtons(this._page, info.id, info.name, this._playback);
    const place = this._page.slots.take;
    place.replaceChildren(
      element("h2", {}, "Take"),
      element("p", { class: "state-line" }, element("strong", { class: "name" }, info.name)),
      this._figures, this._reading, this._problems, this._part, this._downloads);
    const hello = this._page.connection.hello;
    if (hello?.mode !== "take")
      this._addBack("live", "Back to live");
    else if (hello.take && hello.take !== info.id)
      this._addBack("back", `Back to ${fileNameOf(hello.source)}`);
    this.showPart();
  }

  private _addBack(icon: IconName, words: string): void {
    const button = wordButton(icon, words, this._back);
    button.title = words;
    this._page.slots.take.append(element("div", { class: "buttons" }, button));
  }
}

function fileNameOf(path: string): string {
  return path.slice(Math.max(path.lastIndexOf("/"), path.lastIndexOf("\\")) + 1);
}

function framesOf(frames: number, rate: number | null): string {
  const count = frames.toLocaleString("en").replace(/,/g, " ");
  return rate === null ? `${count} frames` : `${count} at ${Math.round(rate * 100) / 100} Hz`;
}
