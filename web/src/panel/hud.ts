import { element, setText } from "../page/dom";
import type { LiveFeed } from "../live/feed";
import type { Loop } from "../page/loop";
import { milliseconds } from "./format";

const Every = 500;

/** The figures in the corner of the stage: pictures per second, and the delay of the motion. */
export class Hud {
  /** Pictures per second in the last half second. */
  fps = 0;
  private readonly _box = element("div", { class: "hud" });
  private readonly _fps = element("span");
  private readonly _delay = element("span");
  private readonly _loop: Loop;
  private readonly _feed: LiveFeed;
  private _pictures = 0;
  private _since = performance.now();
  private _delays = 0;
  private _count = 0;

  constructor(place: HTMLElement, loop: Loop, feed: LiveFeed) {
    this._loop = loop;
    this._feed = feed;
    this._box.append(this._fps, this._delay, element("span", {}, "Grid 1 m"));
    place.append(this._box);
    loop.add("camera", now => this._update(now));
  }

  private _update(now: number): void {
    if (Number.isFinite(this._feed.delay)) {
      this._delays += this._feed.delay;
      this._count++;
      this._feed.delay = NaN;
    }

    if (now - this._since < Every)
      return;

    this.fps = (this._loop.pictures - this._pictures) * 1000 / (now - this._since);
    this.delay = this._count > 0 ? this._delays / this._count : NaN;
    const before = this._pictures;
    this._pictures = this._loop.pictures;
    this._since = now;
    this._delays = this._count = 0;
    setText(this._fps, this._pictures === before ? "Idle" : `${Math.round(this.fps)} fps`);
    setText(this._delay, milliseconds(this.delay));
    this._delay.hidden = Number.isNaN(this.delay);
  }

  /** Mean delay in the last half second, in milliseconds, or NaN. */
  delay = NaN;
}
