import { watchPixelRatio } from "../page/pixelRatio";

/** Room at the left of the time line and the plot, in CSS pixels: both have the same scale. */
export const Gutter = 56;
export const RightMargin = 14;

/** A canvas for things that change seldom, and one above it for the cursor. */
export class LayeredCanvas {
  readonly element: HTMLElement;
  readonly base: CanvasRenderingContext2D;
  readonly top: CanvasRenderingContext2D;
  width = 0;
  height = 0;
  private _scale = 1;
  private _cursor = -1;

  /** @param redraw Called after the size has changed. */
  constructor(element: HTMLElement, redraw: () => void) {
    this.element = element;
    this.base = this._add();
    this.top = this._add();
    const fit = (): void => {
      if (this._resize())
        redraw();
    };
    new ResizeObserver(fit).observe(element);
    watchPixelRatio(fit);
  }

  /** Width of the axis of time. */
  get axis(): number {
    return Math.max(1, this.width - Gutter - RightMargin);
  }

  /** A colour of the page's theme. */
  colour(name: string): string {
    return getComputedStyle(this.element).getPropertyValue(name).trim();
  }

  /** Empties the lower canvas. */
  begin(): CanvasRenderingContext2D {
    this.base.setTransform(this._scale, 0, 0, this._scale, 0, 0);
    this.base.clearRect(0, 0, this.width, this.height);
    return this.base;
  }

  /** Moves the line of the cursor. Allocates nothing. */
  setCursor(x: number, colour: string): void {
    const place = x < Gutter - 1 || x > this.width - RightMargin + 1 ? -1 : Math.round(x * this._scale);
    if (place === this._cursor)
      return;

    const thickness = Math.max(1, Math.round(1.5 * this._scale));
    this.top.setTransform(1, 0, 0, 1, 0, 0);
    this.top.clearRect(this._cursor - thickness - 1, 0, 2 * thickness + 4, this.top.canvas.height);
    this._cursor = place;
    if (place < 0)
      return;

    this.top.fillStyle = colour;
    this.top.fillRect(place - thickness / 2, 0, thickness, this.top.canvas.height);
  }

  private _add(): CanvasRenderingContext2D {
    const canvas = document.createElement("canvas");
    canvas.setAttribute("aria-hidden", "true");
    this.element.append(canvas);
    return canvas.getContext("2d")!;
  }

  private _resize(): boolean {
    const width = this.element.clientWidth;
    const height = this.element.clientHeight;
    const scale = Math.min(2, devicePixelRatio || 1);
    if (width === 0 || height === 0 || width === this.width && height === this.height && scale === this._scale)
      return false;

    this.width = width;
    this.height = height;
    this._scale = scale;
    this._cursor = -1;
    for (const context of [this.base, this.top]) {
      context.canvas.width = Math.round(width * scale);
      context.canvas.height = Math.round(height * scale);
    }

    return true;
  }
}
