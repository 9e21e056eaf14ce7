import { element } from "../page/dom";
import { Gutter, LayeredCanvas, RightMargin } from "./canvas";
import type { Stretch, TakeContacts } from "./info";
import type { Playback } from "./playback";
import { timeMark, timeStep } from "./ticks";
import type { TimeView } from "./timeView";

/** What the time line shows of one performer. */
export interface Lane {
  readonly name: string;
  readonly colour: string;
  readonly start: number;
  readonly end: number;
  readonly gaps: readonly Stretch[];
  readonly contacts: TakeContacts | null;
}

const RulerHeight = 22;
const LaneHeight = 24;
const LeastLaneHeight = 4;
// More lanes share the height of these.
const FullLanes = 6;
const LabelledHeight = 20;
const PixelsPerMark = 84;

/** The time line: ruler, frames and gaps of each performer, contacts of the feet, the chosen part and the cursor. */
export class Timeline {
  readonly element: HTMLElement;
  /** Called when a person moves the cursor. */
  onSeek: ((time: number) => void) | null = null;
  /** Called when a person has moved the cursor and lets go. */
  onSeekEnd: (() => void) | null = null;
  private readonly _canvas: LayeredCanvas;
  private readonly _playback: Playback;
  private readonly _view: TimeView;
  private _lanes: readonly Lane[] = [];
  private _laneHeight = LaneHeight;
  private _cursorColour = "";

  constructor(playback: Playback, view: TimeView) {
    this._playback = playback;
    this._view = view;
    this.element = element("div", {
      class: "time-track", role: "slider", tabindex: "0", "aria-label": "Time of the take", "aria-valuemin": "0", "aria-orientation": "horizontal",
    });
    this._canvas = new LayeredCanvas(this.element, () => this.draw());
    view.onChange(() => this.draw());
    connectSeeking(this.element, this._canvas, view, time => this.onSeek?.(time), () => this.onSeekEnd?.());
  }

  show(lanes: readonly Lane[]): void {
    this._lanes = lanes;
    this._laneHeight = laneHeight(lanes.length);
    this.element.style.height = `${RulerHeight + Math.max(1, lanes.length) * this._laneHeight + 6}px`;
    this.draw();
  }

  /** Moves the cursor. Allocates nothing. */
  setCursor(time: number): void {
    this._canvas.setCursor(xOf(time, this._view, this._canvas.axis), this._cursorColour);
  }

  draw(): void {
    const canvas = this._canvas;
    if (canvas.width === 0)
      return;

    const context = canvas.begin();
    const line = canvas.colour("--line");
    const dim = canvas.colour("--dim");
    this._cursorColour = canvas.colour("--accent");
    drawRuler(context, canvas, this._view, dim, line);
    this._lanes.forEach((lane, i) => this._drawLane(context, lane, RulerHeight + i * this._laneHeight, dim));
    this._drawPart(context, canvas.colour("--background"), this._cursorColour);
    this.setCursor(this._playback.time);
  }

  private _drawLane(context: CanvasRenderingContext2D, lane: Lane, top: number, dim: string): void {
    const { _canvas: canvas, _view: view, _laneHeight: height } = this;
    const x = (time: number): number => xOf(time, view, canvas.axis);
    context.fillStyle = lane.colour;
    context.beginPath();
    context.arc(12, top + height / 2, Math.min(4, height / 2 - 0.5), 0, 2 * Math.PI);
    context.fill();
    context.fillStyle = dim;
    context.font = "10px system-ui, sans-serif";
    context.textAlign = "right";
    context.textBaseline = "middle";
    if (lane.contacts && height >= LabelledHeight) {
      context.fillText("L", Gutter - 8, top + 7.5);
      context.fillText("R", Gutter - 8, top + 17.5);
    }

    clipToAxis(context, canvas, () => {
      context.globalAlpha = 0.16;
      context.fillStyle = lane.colour;
      context.fillRect(x(lane.start), top + 1, Math.max(1, x(lane.end) - x(lane.start)), Math.max(2, height - 2));
      context.globalAlpha = 1;
      for (const gap of lane.gaps)
        drawGap(context, x(gap[0]), x(gap[1]), top, height, canvas.colour("--panel"), dim);
      context.fillStyle = lane.colour;
      if (lane.contacts) {
        drawSteps(context, lane.contacts.left, view, x, top + height / 6, height / 4);
        drawSteps(context, lane.contacts.right, view, x, top + height * 7 / 12, height / 4);
      }
    });
  }

  // What is not played is covered.
  private _drawPart(context: CanvasRenderingContext2D, cover: string, edge: string): void {
    const { _canvas: canvas, _view: view, _playback: playback } = this;
    if (playback.from === null && playback.to === null)
      return;

    clipToAxis(context, canvas, () => {
      const from = xOf(playback.start, view, canvas.axis);
      const to = xOf(playback.end, view, canvas.axis);
      context.globalAlpha = 0.7;
      context.fillStyle = cover;
      context.fillRect(0, RulerHeight, from, canvas.height);
      context.fillRect(to, RulerHeight, canvas.width - to, canvas.height);
      context.globalAlpha = 1;
      context.fillStyle = edge;
      context.fillRect(from, RulerHeight - 6, to - from, 3);
      context.fillRect(from - 1, RulerHeight - 6, 2, canvas.height);
      context.fillRect(to - 1, RulerHeight - 6, 2, canvas.height);
    });
  }
}

/** Pixels for each performer: all of them are visible. */
export function laneHeight(lanes: number): number {
  return Math.max(LeastLaneHeight, Math.min(LaneHeight, Math.floor(FullLanes * LaneHeight / Math.max(1, lanes))));
}

/** The place of a time, in CSS pixels. */
export function xOf(time: number, view: TimeView, axis: number): number {
  return Gutter + (time - view.from) / (view.to - view.from) * axis;
}

/** Lets a pointer choose the time, and the wheel choose the visible part. Of several fingers, the first one does. */
export function connectSeeking(target: HTMLElement, canvas: LayeredCanvas, view: TimeView, seek: (time: number) => void, end: () => void): void {
  const timeAt = (event: MouseEvent): number =>
    view.from + (event.clientX - target.getBoundingClientRect().left - Gutter) / canvas.axis * view.span;
  let held = -1;
  target.addEventListener("pointerdown", event => {
    if (event.button !== 0 || target.hasPointerCapture(held))
      return;

    held = event.pointerId;
    target.setPointerCapture(held);
    target.focus({ preventScroll: true });
    seek(timeAt(event));
  });
  target.addEventListener("pointermove", event => {
    if (event.pointerId === held && target.hasPointerCapture(held))
      seek(timeAt(event));
  });
  target.addEventListener("lostpointercapture", event => {
    if (event.pointerId === held)
      end();
  });
  target.addEventListener("wheel", event => {
    event.preventDefault();
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY))
      view.pan((event.deltaX || event.deltaY) / canvas.axis * view.span);
    else
      view.zoom(Math.exp(event.deltaY * 0.0015), timeAt(event));
  }, { passive: false });
  target.addEventListener("dblclick", () => view.showAll());
}

/** Vertical lines and times. */
export function drawRuler(context: CanvasRenderingContext2D, canvas: LayeredCanvas, view: TimeView, text: string, line: string, labels = true): void {
  const step = timeStep(view.span, canvas.axis / PixelsPerMark);
  context.font = "11px system-ui, sans-serif";
  context.textAlign = "left";
  context.textBaseline = "middle";
  for (let i = Math.ceil(view.from / step); i * step <= view.to; i++) {
    const x = Math.round(xOf(i * step, view, canvas.axis)) + 0.5;
    context.fillStyle = line;
    context.fillRect(x - 0.5, labels ? 6 : 0, 1, canvas.height);
    context.fillStyle = text;
    if (labels && x < canvas.width - 34)
      context.fillText(timeMark(i * step, step), x + 4, 10);
  }
}

export function clipToAxis(context: CanvasRenderingContext2D, canvas: LayeredCanvas, draw: () => void): void {
  context.save();
  context.beginPath();
  context.rect(Gutter - 1, 0, canvas.width - Gutter - RightMargin + 2, canvas.height);
  context.clip();
  draw();
  context.restore();
}

function drawSteps(context: CanvasRenderingContext2D, steps: readonly Stretch[], view: TimeView, x: (time: number) => number, top: number, height: number): void {
  let last = -Infinity;
  for (const [from, to] of steps) {
    if (to < view.from || from > view.to)
      continue;

    // At hours in a picture, steps closer than a pixel are one.
    const start = Math.max(x(from), last);
    const end = Math.max(x(to), start + 0.75);
    context.fillRect(start, top, end - start, height);
    last = end;
  }
}

// Diagonal lines.
function drawGap(context: CanvasRenderingContext2D, from: number, to: number, top: number, height: number, background: string, line: string): void {
  const width = Math.max(2, to - from);
  context.save();
  context.beginPath();
  context.rect(from, top + 1, width, Math.max(2, height - 2));
  context.clip();
  context.fillStyle = background;
  context.fillRect(from, top, width, height);
  context.strokeStyle = line;
  context.globalAlpha = 0.5;
  context.beginPath();
  const start = Math.max(from, 0) - height;
  for (let x = start; x < Math.min(to, context.canvas.width); x += 6) {
    context.moveTo(x, top + height);
    context.lineTo(x + height, top);
  }

  context.stroke();
  context.restore();
}
