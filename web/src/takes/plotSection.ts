import { element } from "../page/dom";
import type { Api } from "../page/api";
import { wordsOf } from "./boneWords";
import type { CurveData, TakeInfo } from "./info";
import { Plot } from "./plot";
import type { TimeView } from "./timeView";

const Quantities = [["height", "Height"], ["angle", "Angle"], ["speed", "Speed"]] as const;
const MostCurves = 64;
const WaitForMore = 60;

/** The plot with its choices. Asks the server for the visible part. */
export class PlotSection {
  readonly element = element("div", { class: "plot-section" });
  readonly plot: Plot;
  private readonly _api: Api;
  private readonly _view: TimeView;
  private readonly _bone = element("select", { "aria-label": "Bone" });
  private readonly _quantity = element("select", { "aria-label": "Quantity" });
  private readonly _say: (error: Error) => void;
  private _info: TakeInfo | null = null;
  private _timer = 0;
  private _abort: AbortController | null = null;

  constructor(api: Api, view: TimeView, say: (error: Error) => void) {
    this._api = api;
    this._view = view;
    this._say = say;
    this.plot = new Plot(view);
    this.plot.onResize = () => this._ask();
    this._quantity.append(...Quantities.map(([value, words]) => element("option", { value }, words)));
    this._quantity.addEventListener("change", () => this._ask());
    this._bone.addEventListener("change", () => this._ask());
    view.onChange(() => this._ask());
    const choices = element("div", { class: "plot-choices" },
      element("label", {}, element("span", {}, "Plot"), this._quantity), element("label", {}, element("span", {}, "of"), this._bone));
    this.element.append(choices, this.plot.element);
  }

  show(info: TakeInfo): void {
    const isNew = this._info?.id !== info.id || this._bone.options.length === 0;
    this._info = info;
    if (isNew && info.performers.length > 0) {
      const { bones, variant } = info.performers[0];
      this._bone.replaceChildren(...bones.map(({ name }) => element("option", { value: name, title: name }, wordsOf(name, variant))));
      this.plot.show([], "Plot");
    }

    this._ask();
  }

  /** Asks again, for example after the plot was hidden. */
  refresh(): void {
    this._ask();
  }

  close(): void {
    this._info = null;
    clearTimeout(this._timer);
    this._abort?.abort();
    this.plot.show([], "Plot");
    this._bone.replaceChildren();
  }

  private _ask(): void {
    clearTimeout(this._timer);
    this._timer = setTimeout(() => void this._load(), WaitForMore) as unknown as number;
  }

  private async _load(): Promise<void> {
    const info = this._info;
    if (!info || this.element.hidden || this.plot.element.clientWidth === 0)
      return;

    this._abort?.abort();
    const abort = this._abort = new AbortController();
    // The variants of the skeleton name two bones differently.
    const bone = Math.max(0, this._bone.selectedIndex);
    const quantity = this._quantity.value;
    this._bone.title = this._bone.value;
    try {
      const shown = info.performers.slice(0, MostCurves);
      const curves = await Promise.all(shown.map(performer => this._api.get<CurveData>(
        `takes/${encodeURIComponent(info.id)}/curves?performer=${encodeURIComponent(performer.key)}&bone=${encodeURIComponent(performer.bones[bone].name)}&quantity=${quantity}`
        + `&points=${this.plot.points}&from=${this._view.from.toFixed(3)}&to=${this._view.to.toFixed(3)}`, abort.signal)));
      this.plot.show(
        curves.map((data, i) => ({ colour: shown[i].colour, data, gaps: shown[i].gaps })),
        `${quantity} of ${wordsOf(this._bone.value, info.performers[0].variant)} over time, in ${curves[0]?.unit ?? ""}`);
    } catch (error) {
      if ((error as Error).name !== "AbortError")
        this._say(error as Error);
    }
  }
}
