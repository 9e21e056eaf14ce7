import { element, setText } from "../page/dom";
import type { Situation } from "./situation";

/** The message on the stage when there is nothing to see: a card on the empty stage, or a strip above figures that stand still. */
export class Overlay {
  private readonly _box = element("div", { class: "overlay", role: "status" });
  private readonly _dot = element("i", { class: "dot" });
  private readonly _title = element("h2");
  private readonly _text = element("p");
  private readonly _advice = element("p", { class: "advice" });

  constructor(place: HTMLElement) {
    this._box.append(this._dot, this._title, this._text, this._advice);
    this._box.hidden = true;
    place.append(this._box);
  }

  show(situation: Situation, hasFigures: boolean): void {
    this._box.hidden = !situation.needsWords;
    this._box.classList.toggle("strip", hasFigures);
    this._dot.dataset.tone = situation.tone;
    setText(this._title, situation.title);
    setText(this._text, situation.text);
    setText(this._advice, situation.advice);
  }
}
