import type { Page } from "../page/page";
import type { TakeContacts, TakeInfo } from "./info";
import { Playback } from "./playback";
import { PlotSection } from "./plotSection";
import { TakePlayer } from "./takePlayer";
import { TakeSection } from "./takeSection";
import { Timeline } from "./timeline";
import { TimeView } from "./timeView";
import { Transport } from "./transport";

const ReadoutEvery = 66;

/** A take on the page: its motion, the time line with its keys, the plot, and the section of the panel. */
export class TakeScreen {
  private readonly _page: Page;
  private readonly _playback = new Playback();
  private readonly _view = new TimeView();
  private readonly _timeline = new Timeline(this._playback, this._view);
  private readonly _plot: PlotSection;
  private readonly _section: TakeSection;
  private readonly _transport: Transport;
  private _player: TakePlayer | null = null;
  private _contacts: readonly (TakeContacts | null)[] = [];
  private _removeKeys: (() => void) | null = null;
  private _readoutAt = 0;
  private _wasPlaying = false;
  private _hasBegun = false;

  /** @param back Shows again what the program was started with. */
  constructor(page: Page, back: () => void) {
    this._page = page;
    this._plot = new PlotSection(page.api, this._view, error => page.notices.problem(error.message));
    this._plot.element.hidden = matchMedia("(max-width: 40rem), (max-height: 36rem)").matches;
    this._section = new TakeSection(page, this._playback, back);
    this._transport = new Transport(this._playback, {
      step: direction => this._step(direction),
      seek: time => this._seek(time),
      togglePlot: () => this._togglePlot(),
      showAll: () => this._view.showAll(),
    });
    this._transport.setPlot(!this._plot.element.hidden);
    this._playback.onChange = () => {
      this._transport.refresh();
      this._timeline.draw();
      this._section.showPart();
    };
    for (const target of [this._timeline, this._plot.plot]) {
      target.onSeek = time => this._scrub(time);
      target.onSeekEnd = () => this._endScrub();
    }

    this._timeline.element.addEventListener("keydown", event => this._onSliderKey(event));
    new MutationObserver(() => this._redraw()).observe(document.documentElement, { attributeFilter: ["data-theme"] });
    page.loop.add("motion", (now, step) => this._onPicture(now, step));
  }

  /** Plays the take that is shown. Each start of a take makes another one. */
  get player(): TakePlayer | null {
    return this._player;
  }

  /** Puts the time line of a take on the page. */
  start(id: string): TakePlayer {
    this._playback.time = 0;
    this._playback.clearPart();
    this._page.slots.timeline.replaceChildren(this._transport.element, this._timeline.element, this._plot.element);
    this._removeKeys = this._transport.addKeys(this._page.keys);
    return this._player = new TakePlayer(this._page, this._playback, id);
  }

  /** Shows what the server knows of the take now. */
  async show(info: TakeInfo): Promise<void> {
    const player = this._player;
    if (!player)
      return;

    this._playback.duration = info.duration;
    this._view.setDuration(info.duration);
    this._section.show(info);
    this._transport.refresh();
    this._drawLanes(info);
    await player.update(info);
    const contacts = await player.loadContacts();
    if (this._player !== player)
      return;

    this._contacts = contacts;
    if (!this._hasBegun)
      this._begin(info);
    this._drawLanes(info);
    this._plot.show(info);
  }

  /** Takes the take off the page. */
  leave(): void {
    this._hasBegun = false;
    this._wasPlaying = false;
    this._player?.dispose();
    this._player = null;
    this._contacts = [];
    this._removeKeys?.();
    this._removeKeys = null;
    this._playback.pause();
    this._playback.duration = 0;
    this._playback.first = 0;
    this._view.setDuration(0);
    this._plot.close();
    this._section.clear();
    this._page.slots.timeline.replaceChildren();
  }

  // Recordings begin before their first frame. While the server reads a file, it can know a performer and no frame.
  private _begin(info: TakeInfo): void {
    const performers = info.performers.filter(performer => performer.frames > 0);
    if (performers.length === 0)
      return;

    this._hasBegun = true;
    this._playback.first = Math.min(...performers.map(performer => performer.start));
    this._seek(this._playback.first);
    if (performers.some(performer => performer.frames > 1) && !matchMedia("(prefers-reduced-motion: reduce)").matches)
      this._playback.toggle();
  }

  private _drawLanes(info: TakeInfo): void {
    this._timeline.show(info.performers.map((performer, i) => ({
      name: performer.name,
      colour: performer.colour,
      start: performer.start,
      end: performer.end,
      gaps: performer.gaps,
      contacts: this._contacts[i] ?? null,
    })));
    this._timeline.element.setAttribute("aria-valuemax", (info.duration / 1000).toFixed(3));
  }

  // Waits for frames rather than skipping them.
  private _onPicture(now: number, step: number): void {
    const player = this._player;
    if (!player)
      return;

    if (this._playback.playing && player.isReady(this._playback.time, 1)) {
      this._playback.advance(step);
      if (this._playback.time > this._view.to && !this._view.isWhole)
        this._view.reveal(this._playback.time);
    }

    if (!player.show())
      return;

    this._timeline.setCursor(this._playback.time);
    this._plot.plot.setCursor(this._playback.time);
    if (now - this._readoutAt > ReadoutEvery || !this._playback.playing)
      this._readOut(now, player);
  }

  private _readOut(now: number, player: TakePlayer): void {
    this._readoutAt = now;
    this._transport.showTime(this._playback.time, player.frame, player.frames, player.isGap);
    const slider = this._timeline.element;
    slider.setAttribute("aria-valuenow", (this._playback.time / 1000).toFixed(3));
    slider.setAttribute("aria-valuetext", `${(this._playback.time / 1000).toFixed(2)} seconds`);
  }

  private _seek(time: number): void {
    this._playback.seek(time);
    this._view.reveal(this._playback.time);
  }

  private _step(direction: number): void {
    this._playback.pause();
    const time = this._player?.timeOfStep(direction);
    if (time !== null && time !== undefined)
      this._seek(time);
  }

  private _scrub(time: number): void {
    this._wasPlaying ||= this._playback.playing;
    this._playback.pause();
    this._playback.seek(time);
  }

  private _endScrub(): void {
    if (this._wasPlaying && this._player)
      this._playback.toggle();
    this._wasPlaying = false;
  }

  private _togglePlot(): void {
    this._plot.element.hidden = !this._plot.element.hidden;
    this._transport.setPlot(!this._plot.element.hidden);
    requestAnimationFrame(() => this._plot.refresh());
  }

  private _onSliderKey(event: KeyboardEvent): void {
    const step = event.key === "ArrowLeft" || event.key === "ArrowDown" ? -1 : event.key === "ArrowRight" || event.key === "ArrowUp" ? 1 : 0;
    if (step === 0 || event.ctrlKey || event.altKey || event.metaKey)
      return;

    event.preventDefault();
    event.stopPropagation();
    if (event.shiftKey)
      this._seek(this._playback.time + step * 1000);
    else
      this._step(step);
  }

  // The colours are those of the theme.
  private _redraw(): void {
    this._timeline.draw();
    this._plot.plot.draw();
  }
}
