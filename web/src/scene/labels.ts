import { Vector3 } from "three";
import { element } from "../page/dom";
import type { Performers } from "./performers";
import type { Stage } from "./stage";

const AboveHead = 0.3;

/** The names above the performers' heads. */
export class Labels {
  private readonly _place: HTMLElement;
  private readonly _performers: Performers;
  private readonly _stage: Stage;
  private readonly _labels = new Map<string, HTMLElement>();
  private readonly _point = new Vector3();

  constructor(place: HTMLElement, performers: Performers, stage: Stage) {
    this._place = element("div", { class: "labels", "aria-hidden": "true" });
    place.append(this._place);
    this._performers = performers;
    this._stage = stage;
    performers.onChange(() => this._rebuild());
  }

  update(visible: boolean, mirrored: boolean): void {
    this._place.hidden = !visible;
    if (!visible)
      return;

    const { clientWidth: width, clientHeight: height } = this._stage.canvas;
    for (const performer of this._performers.all) {
      const label = this._labels.get(performer.info.key);
      if (!label)
        continue;

      const head = Math.max(0, performer.body.indexOf("Head")) * 3;
      const positions = performer.body.positions;
      this._point.set(positions[head], positions[head + 1] + AboveHead, positions[head + 2]).project(this._stage.camera);
      const isSeen = performer.hasPose && !performer.hidden && Math.abs(this._point.z) < 1 && Math.abs(this._point.x) < 1.05;
      label.hidden = !isSeen;
      if (!isSeen)
        continue;

      const x = (mirrored ? -this._point.x : this._point.x) * 0.5 + 0.5;
      label.style.transform = `translate(${(x * width).toFixed(1)}px, ${((0.5 - this._point.y * 0.5) * height).toFixed(1)}px) translate(-50%, -100%)`;
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
      this._labels.set(performer.info.key, label);
      this._place.append(label);
    }
  }
}
