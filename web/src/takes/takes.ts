import type { Hello } from "../live/messages";
import { ApiError } from "../page/api";
import type { Page, Takes } from "../page/page";
import { findTakes, TakeEndings } from "./files";
import type { TakeContacts, TakeInfo } from "./info";
import { Playback } from "./playback";
import { PlotSection } from "./plotSection";
import { TakePlayer } from "./takePlayer";
import { TakeSection } from "./takeSection";
import { Timeline } from "./timeline";
import { TimeView } from "./timeView";
import { Transport } from "./transport";
import { Wishes } from "./wishes";

const AskAgain = 500;
const NotFound = 404;
const ReadoutEvery = 66;
// That of --upload-limit, in bytes.
const Megabyte = 1024 * 1024;

/** Recordings on the page: dropped files, the time line, and plots under it. */
export function createTakes(page: Page): Takes {
  return new TakeScreen(page);
}

class TakeScreen implements Takes {
  private readonly _page: Page;
  private readonly _playback = new Playback();
  private readonly _view = new TimeView();
  private readonly _timeline = new Timeline(this._playback, this._view);
  private readonly _plot: PlotSection;
  private readonly _section: TakeSection;
  private readonly _transport: Transport;
  private _current: string | null = null;
  private _player: TakePlayer | null = null;
  private _contacts: readonly (TakeContacts | null)[] = [];
  private _removeKeys: (() => void) | null = null;
  private _readoutAt = 0;
  private _wasPlaying = false;
  private _hasBegun = false;
  private readonly _wishes = new Wishes();

  constructor(page: Page) {
    this._page = page;
    this._plot = new PlotSection(page.api, this._view, error => page.notices.problem(error.message));
    this._plot.element.hidden = matchMedia("(max-width: 40rem), (max-height: 36rem)").matches;
    this._section = new TakeSection(page, this._playback, () => this.close());
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
    page.connection.onMessage(message => {
      if (message.type === "hello")
        void page.notices.attempt(() => this._check(message));
    });
    page.drops.add({
      what: "takes (BVH, .nmrec, .calc)",
      endings: TakeEndings,
      accepts: files => findTakes(files).length > 0,
      take: files => {
        const [first, ...others] = findTakes(files);
        if (others.length > 0)
          page.notices.say(`The page shows one take at a time. It opens ${first.name}.`);
        void this._upload(first);
      },
    });
  }

  get current(): string | null {
    return this._current;
  }

  async open(id: string): Promise<void> {
    const wish = this._wishes.replace();

    // Also while a file that was dropped later is still on its way.
    await this._open(id, wish, () => this._wishes.has(wish));
  }

  // Returns false if another take was shown or asked for meanwhile.
  private async _open(id: string, wish: symbol, isWanted: () => boolean): Promise<boolean> {
    const info = await this._page.api.get<TakeInfo>(`takes/${encodeURIComponent(id)}`).catch(error => {
      this._wishes.withdraw(wish);
      throw error;
    });
    if (!isWanted())
      return false;

    this._wishes.fulfil(wish);
    this._leave();
    this._current = id;
    this._page.feed.pause();
    this._page.performers.clear();
    this._playback.time = 0;
    this._playback.clearPart();
    const player = this._player = new TakePlayer(this._page, this._playback, id);
    this._page.slots.timeline.replaceChildren(this._transport.element, this._timeline.element, this._plot.element);
    this._removeKeys = this._transport.addKeys(this._page.keys);
    let isShown = false;
    try {
      await this._show(info, player);
      isShown = true;
    } finally {
      void this._watch(player, info, isShown);
    }

    return true;
  }

  close(): void {
    this._wishes.replace();
    if (this._current === null)
      return;

    this._leave();
    this._page.performers.clear();
    this._page.feed.resume();
    this._page.loop.invalidate();
  }

  private _leave(): void {
    this._current = null;
    this._hasBegun = false;
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

  private async _upload(file: File): Promise<void> {
    const { api, notices, connection } = this._page;
    const most = connection.hello?.uploadLimit ?? Infinity;
    if (file.size > most) {
      notices.problem(`${file.name} is larger than ${most / Megabyte} MB. Start the program with a larger --upload-limit, or with the file itself.`);
      return;
    }

    // A file that cannot be opened does not replace the one before it.
    const wish = this._wishes.add();
    const cancel = new AbortController();
    const progress = notices.progress(`Opening ${file.name}`, () => cancel.abort());
    await notices.attempt(async () => {
      const address = `takes?name=${encodeURIComponent(file.name)}`;
      const { id } = await api.upload<{ id: string }>(address, file, part => progress.show(part), cancel.signal).catch(error => {
        this._wishes.withdraw(wish);
        throw error;
      });
      const isLast = () => this._wishes.isLast(wish);
      if (!isLast() || !await this._open(id, wish, isLast))
        notices.offer(`${file.name} is ready.`, "Show", () => void notices.attempt(() => this.open(id)));
    });
    progress.end();
  }

  // A program that was started again has none of the takes that were open, and may show a file.
  private async _check(hello: Hello): Promise<void> {
    const player = this._player;
    const offered = hello.mode === "take" && hello.take ? hello.take : null;
    if (this._current === null && offered !== null)
      await this.open(offered);
    if (this._current === null || this._current === hello.take)
      return;

    try {
      await this._page.api.get<TakeInfo>(`takes/${encodeURIComponent(this._current)}`);
    } catch (error) {
      if (this._player !== player || !(error instanceof ApiError) || error.status !== NotFound)
        return;

      this._page.notices.problem(error.message);
      if (offered !== null)
        await this.open(offered);
      else
        this.close();
    }
  }

  // Asks again while the server reads the file, and after it did not answer. A tab in the background asks for nothing.
  private async _watch(player: TakePlayer, info: TakeInfo, isShown: boolean): Promise<void> {
    let known = info;
    while (known.progress < 1 || !isShown) {
      await new Promise(resolve => setTimeout(resolve, AskAgain));
      await this._page.connection.opened();
      if (this._player !== player)
        return;

      try {
        const now = await this._page.api.get<TakeInfo>(`takes/${encodeURIComponent(info.id)}`);
        if (this._player !== player)
          return;

        await this._show(now, player);
        [known, isShown] = [now, true];
      } catch (error) {
        if (error instanceof ApiError && error.status === 0)
          continue;

        this._page.notices.problem((error as Error).message);
        return;
      }
    }
  }

  private async _show(info: TakeInfo, player: TakePlayer): Promise<void> {
    this._playback.duration = info.duration;
    this._view.setDuration(info.duration);
    this._section.show(info);
    this._transport.refresh();
    this._drawLanes(info);
    await player.update(info);
    this._contacts = await player.loadContacts();
    if (this._player !== player)
      return;

    if (!this._hasBegun)
      this._begin(info);
    this._drawLanes(info);
    this._plot.show(info);
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
