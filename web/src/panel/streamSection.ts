import { element, setText } from "../page/dom";
import type { Status } from "../live/messages";
import { bytes, count, milliseconds, short } from "./format";
import type { Situation } from "./situation";

const Rows = {
  rate: "Frames per second",
  latency: "Latency",
  jitter: "Jitter",
  data: "Data",
  lost: "Lost frames",
  dropped: "Late frames",
  reconnects: "Reconnections",
} as const;

/** The section of the panel that tells how the stream is. */
export class StreamSection {
  /** Holds buttons below the figures. */
  readonly buttons = element("div", { class: "buttons" });
  private readonly _state = element("p", { class: "state-line" });
  private readonly _dot = element("i", { class: "dot" });
  private readonly _title = element("strong");
  private readonly _words = element("p", { class: "words" });
  private readonly _advice = element("p", { class: "advice" });
  private readonly _values = new Map<keyof typeof Rows, HTMLElement>();

  constructor(place: HTMLElement) {
    this._state.append(this._dot, this._title);
    const list = element("dl", { class: "figures" });
    for (const [name, words] of Object.entries(Rows) as [keyof typeof Rows, string][]) {
      const value = element("dd", {}, "–");
      this._values.set(name, value);
      list.append(element("div", {}, element("dt", {}, words), value));
    }

    place.append(element("h2", {}, "Stream"), this._state, this._words, this._advice, list, this.buttons);
  }

  /** @param delay Milliseconds from the server to the picture, or NaN. */
  show(situation: Situation, status: Status | null, delay: number): void {
    this._dot.dataset.tone = situation.tone;
    setText(this._title, situation.title);
    setText(this._words, situation.text);
    setText(this._advice, situation.advice);
    const performers = status?.performers ?? [];
    const rates = performers.map(each => each.fps);
    const jitters = performers.map(each => each.jitter).filter(each => each !== null);
    this._set("rate", rates.length === 0 ? "–" : isEven(rates) ? short(Math.max(...rates)) : `${short(Math.min(...rates))} to ${short(Math.max(...rates))}`);
    this._set("latency", milliseconds(delay));
    this._set("jitter", milliseconds(jitters.length === 0 ? null : Math.max(...jitters)));
    this._set("data", status ? `${bytes(status.bytesPerSecond)}/s` : "–");
    this._set("lost", status ? count(performers.reduce((sum, each) => sum + each.lost, 0)) : "–");
    this._set("dropped", status ? count(performers.reduce((sum, each) => sum + each.dropped, 0)) : "–");
    this._set("reconnects", status ? count(status.reconnects) : "–");
  }

  private _set(name: keyof typeof Rows, text: string): void {
    setText(this._values.get(name)!, text);
  }
}

function isEven(rates: readonly number[]): boolean {
  return Math.max(...rates) - Math.min(...rates) < 1.5;
}
