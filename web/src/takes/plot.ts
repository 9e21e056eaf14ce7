import { element } from "../page/dom";
import { Gutter, LayeredCanvas } from "./canvas";
import type { CurveData, Stretch } from "./info";
import { decimalsOf, valueStep } from "./ticks";
import { clipToAxis, connectSeeking, drawRuler, xOf } from "./timeline";
import type { TimeView } from "./timeView";

/** A curve of one performer. */
export interface PlotCurve {
  readonly colour: string;
  readonly data: CurveData;
  readonly gaps: readonly Stretch[];
}

export interface Range {
  readonly low: number;
  readonly high: number;
}

const Top = 14;
const Bottom = 10;
const PixelsPerMark = 34;

/** A plot of a quantity over time, on the scale of the time line. */
export class Plot {
  readonly element = element("div", { class: "time-plot", role: "img", "aria-label": "Plot" });
  onSeek: ((time: number) => void) | null = null;
  onSeekEnd: (() => void) | null = null;
  /** Called when there is room for another number of points. */
  onResize: (() => void) | null = null;
  private readonly _canvas: LayeredCanvas;
  private readonly _view: TimeView;
  private _curves: readonly PlotCurve[] = [];
  private _cursorColour = "";

  constructor(view: TimeView) {
    this._view = view;
    this._canvas = new LayeredCanvas(this.element, () => {
      this.draw();
      this.onResize?.();
    });
    view.onChange(() => this.draw());
    connectSeeking(this.element, this._canvas, view, time => this.onSeek?.(time), () => this.onSeekEnd?.());
  }

  /** Number of points that the width has room for. */
  get points(): number {
    return Math.max(100, Math.min(2000, Math.round(this._canvas.axis)));
  }

  show(curves: readonly PlotCurve[], words: string): void {
    this._curves = curves;
    this.element.setAttribute("aria-label", words);
    this.draw();
  }

  /** Moves the cursor. Allocates nothing. */
  setCursor(time: number): void {
    this._canvas.setCursor(xOf(time, this._view, this._canvas.axis), this._cursorColour);
  }

  draw(): void {
    const { _canvas: canvas, _view: view } = this;
    if (canvas.width === 0)
      return;

    const context = canvas.begin();
    const line = canvas.colour("--line");
    const dim = canvas.colour("--dim");
    this._cursorColour = canvas.colour("--accent");
    drawRuler(context, canvas, view, dim, line, false);
    const range = rangeOf(this._curves);
    if (!range) {
      context.fillStyle = dim;
      context.font = "12px system-ui, sans-serif";
      context.textAlign = "center";
      context.textBaseline = "middle";
      if (this._curves.length > 0)
        context.fillText("No values in this part of the take", canvas.width / 2, canvas.height / 2);
      return;
    }

    const bottom = canvas.height - Bottom;
    const y = (value: number): number => bottom - (value - range.low) / (range.high - range.low) * (bottom - Top);
    this._drawAxis(context, range, y, dim, line);
    clipToAxis(context, canvas, () => {
      for (const curve of this._curves)
        drawCurve(context, curve, time => xOf(time, view, canvas.axis), y);
    });
  }

  private _drawAxis(context: CanvasRenderingContext2D, range: Range, y: (value: number) => number, text: string, line: string): void {
    const canvas = this._canvas;
    const step = valueStep(range.high - range.low, (canvas.height - Top - Bottom) / PixelsPerMark);
    const decimals = decimalsOf(step);
    context.font = "11px system-ui, sans-serif";
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (let i = Math.ceil(range.low / step - 1e-6); i * step <= range.high + step * 1e-6; i++) {
      const place = Math.round(y(i * step));
      context.fillStyle = line;
      context.fillRect(Gutter, place, canvas.axis, 1);
      context.fillStyle = text;
      context.fillText((i * step).toFixed(decimals), Gutter - 8, place);
    }

    context.textAlign = "left";
    context.fillText(this._curves[0].data.unit, 6, 8);
  }
}

/** The lowest and highest value of all curves, with some room. Null without values. */
export function rangeOf(curves: readonly PlotCurve[]): Range | null {
  let low = Infinity;
  let high = -Infinity;
  for (const { data } of curves) {
    for (let i = 0; i < data.times.length; i++) {
      low = Math.min(low, data.min[i] ?? Infinity);
      high = Math.max(high, data.max[i] ?? -Infinity);
    }
  }

  if (low > high)
    return null;

  // A constant is in the middle.
  const room = high - low > 1e-6 ? (high - low) * 0.06 : Math.max(0.05, Math.abs(high) * 0.05);
  return { low: low >= 0 && low < (high - low) * 0.5 ? 0 : low - room, high: high + room };
}

// A band between the lowest and highest values, and a line through their middle. Both break at gaps.
function drawCurve(context: CanvasRenderingContext2D, { colour, data, gaps }: PlotCurve, x: (time: number) => number, y: (value: number) => number): void {
  context.lineJoin = "round";
  for (const [first, last] of runsOf(data, gaps)) {
    context.fillStyle = colour;
    context.globalAlpha = 0.3;
    context.beginPath();
    for (let i = first; i <= last; i++)
      context.lineTo(x(data.times[i]), y(data.max[i]!));
    for (let i = last; i >= first; i--)
      context.lineTo(x(data.times[i]), y(data.min[i]!));
    context.fill();
    context.globalAlpha = 1;
    context.strokeStyle = colour;
    context.lineWidth = 1.5;
    context.beginPath();
    for (let i = first; i <= last; i++)
      context.lineTo(x(data.times[i]), y((data.max[i]! + data.min[i]!) / 2));
    context.stroke();
    if (first === last) {
      context.fillStyle = colour;
      context.fillRect(x(data.times[first]) - 1.5, y(data.max[first]!) - 1.5, 3, 3);
    }
  }
}

/** The stretches of points without a hole or a gap between them, as pairs of first and last index. */
export function runsOf(data: CurveData, gaps: readonly Stretch[]): [number, number][] {
  const runs: [number, number][] = [];
  let first = -1;
  let gap = 0;
  for (let i = 0; i <= data.times.length; i++) {
    const isKnown = i < data.times.length && data.min[i] !== null && data.max[i] !== null;
    let isAfterGap = false;
    while (isKnown && gap < gaps.length && gaps[gap][1] <= data.times[i] + 1e-6) {
      isAfterGap ||= first >= 0 && gaps[gap][0] >= data.times[first] - 1e-6;
      gap++;
    }

    if (first >= 0 && (!isKnown || isAfterGap)) {
      runs.push([first, i - 1]);
      first = -1;
    }

    if (isKnown && first < 0)
      first = i;
  }

  return runs;
}
