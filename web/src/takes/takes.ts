import type { Hello } from "../live/messages";
import { ApiError } from "../page/api";
import type { Page, Takes } from "../page/page";
import { findTakes, TakeEndings } from "./files";
import type { TakeInfo } from "./info";
import type { TakePlayer } from "./takePlayer";
import { TakeScreen } from "./takeScreen";
import { Wishes } from "./wishes";

const AskAgain = 500;
const NotFound = 404;
// That of --upload-limit, in bytes.
const Megabyte = 1024 * 1024;

/** Recordings on the page: dropped files, the time line, and plots under it. */
export function createTakes(page: Page): Takes {
  return new OpenTakes(page);
}

/** Which take is shown: files are uploaded, opened and left, and the program may be started again meanwhile. */
class OpenTakes implements Takes {
  private readonly _page: Page;
  private readonly _screen: TakeScreen;
  private readonly _wishes = new Wishes();
  private readonly _listeners: (() => void)[] = [];
  private _info: TakeInfo | null = null;

  constructor(page: Page) {
    this._page = page;
    this._screen = new TakeScreen(page, () => this._goBack());
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
    return this._info?.id ?? null;
  }

  get info(): TakeInfo | null {
    return this._info;
  }

  onChange(listener: () => void): void {
    this._listeners.push(listener);
  }

  async open(id: string): Promise<void> {
    const wish = this._wishes.replace();
    const info = await this._load(id, wish);

    // Also while a file that was dropped later is still on its way.
    if (this._wishes.has(wish))
      await this._start(info, wish);
  }

  close(): void {
    this._wishes.replace();
    if (this._info === null)
      return;

    this._leave();
    this._page.performers.clear();
    this._page.feed.resume();
    this._page.loop.invalidate();
  }

  private _goBack(): void {
    const take = this._page.connection.hello?.take;
    if (take)
      void this._page.notices.attempt(() => this.open(take));
    else
      this.close();
  }

  private _leave(): void {
    this._know(null);
    this._screen.leave();
  }

  private _know(info: TakeInfo | null): void {
    this._info = info;
    for (const listener of this._listeners)
      listener();
  }

  private async _load(id: string, wish: symbol): Promise<TakeInfo> {
    try {
      return await this._page.api.get<TakeInfo>(`takes/${encodeURIComponent(id)}`);
    } catch (error) {
      this._wishes.withdraw(wish);
      throw error;
    }
  }

  private async _start(info: TakeInfo, wish: symbol): Promise<void> {
    this._wishes.fulfil(wish);
    this._leave();
    this._know(info);
    this._page.feed.pause();
    this._page.performers.clear();
    const player = this._screen.start(info.id);
    let isShown = false;
    try {
      await this._screen.show(info);
      isShown = true;
    } finally {
      void this._watch(player, info, isShown);
    }
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
      if (!await this._openIfLast(id, wish))
        notices.offer(`${file.name} is ready.`, "Show", () => void notices.attempt(() => this.open(id)));
    });
    progress.end();
  }

  // Returns false if another take was asked for meanwhile.
  private async _openIfLast(id: string, wish: symbol): Promise<boolean> {
    if (!this._wishes.isLast(wish))
      return false;

    const info = await this._load(id, wish);
    if (!this._wishes.isLast(wish))
      return false;

    await this._start(info, wish);
    return true;
  }

  // A program that was started again has none of the takes that were open, and may show a file.
  private async _check(hello: Hello): Promise<void> {
    const { player } = this._screen;
    const offered = hello.mode === "take" && hello.take ? hello.take : null;
    if (this.current === null && offered !== null)
      await this.open(offered);
    if (this.current === null || this.current === hello.take)
      return;

    try {
      await this._page.api.get<TakeInfo>(`takes/${encodeURIComponent(this.current)}`);
    } catch (error) {
      if (this._screen.player !== player || !(error instanceof ApiError) || error.status !== NotFound)
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
      if (this._screen.player !== player)
        return;

      try {
        const now = await this._page.api.get<TakeInfo>(`takes/${encodeURIComponent(info.id)}`);
        if (this._screen.player !== player)
          return;

        this._know(now);
        await this._screen.show(now);
        [known, isShown] = [now, true];
      } catch (error) {
        if (error instanceof ApiError && error.status === 0)
          continue;

        this._page.notices.problem((error as Error).message);
        return;
      }
    }
  }
}
