import { Vector3 } from "three";
import { element } from "../page/dom";
import type { Performers } from "./performers";
import type { Stage } from "./stage";

const AboveHead = 0.3;

interface Label {
  readonly element: HTMLElement;
  readonly head: number;
  /** What the element shows: hidden, or its place in tenths of a pixel. */
  isSeen: boolean;
  x: number;
  y: number;
}

/** The names above the performers' heads. */
export class Labels {
  private readonly _place: HTMLElement;
  private readonly _performers: Performers;
  private readonly _stage: Stage;
  private readonly _labels = new Map<string, Label>();
  private readonly _point = new Vector3();

  constructor(place: HTMLElement, performers: Performers, stage: Stage) {
    this._place = element("div", { class: "labels", "aria-hidden": "true" });
    place.append(this._place);
    this._performers = performers;
    this._stage = stage;
    performers.onChange(() => this._rebuild());
  }

  update(visible: boolean, mirrored: boolean): void {
    if (this._place.hidden === visible)
      this._place.hidden = !visible;
    if (!visible)
      return;

    const { width, height } = this._stage;
    for (const performer of this._performers.all) {
      const label = this._labels.get(performer.info.key);
      if (!label)
        continue;

      const { head } = label;
      const positions = performer.body.positions;
      this._point.set(positions[head], positions[head + 1] + AboveHead, positions[head + 2]).add(performer.group.position).project(this._stage.camera);
      const isSeen = performer.isOnStage && Math.abs(this._point.z) < 1 && Math.abs(this._point.x) < 1.05;
      if (label.isSeen !== isSeen)
        label.element.hidden = !(label.isSeen = isSeen);
      if (!isSeen)
        continue;

      const x = Math.round(((mirrored ? -this._point.x : this._point.x) * 0.5 + 0.5) * width * 10);
      const y = Math.round((0.5 - this._point.y * 0.5) * height * 10);
      if (x === label.x && y === label.y)
        continue;

      label.x = x;
      label.y = y;
      label.element.style.transform = `translate(${x / 10}px, ${y / 10}px) translate(-50%, -100%)`;
    }
  }

  private _rebuild(): void {
    this._labels.clear();
    this._place.replaceChildren();
    for (const performer of this._performers.all) {
      const dot = element("i");
      dot.style.background = performer.info.colour;
      const label = element("span", { class: "label" }, dot, performer.info.name || performer.info.key);
      label.hidden = true;
      this._labels.set(performer.info.key, { element: label, head: Math.max(0, performer.body.indexOf("Head")) * 3, isSeen: false, x: NaN, y: NaN });
      this._place.append(label);
    }
  }
}
