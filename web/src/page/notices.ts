import { element, setText } from "./dom";

/** Shows how far something is. */
export interface ProgressNotice {
  /** @param part 0 to 1. */
  show(part: number): void;
  end(): void;
}

/** Short messages at the edge of the page. Screen readers read them. */
export class Notices {
  private readonly _list: HTMLElement;

  constructor(list: HTMLElement) {
    this._list = list;
  }

  /** Shows a sentence for some seconds. */
  say(text: string): void {
    this._show(text, "notice", 6000);
  }

  /** Shows what went wrong, until it is closed or half a minute has passed. */
  problem(text: string): void {
    this._show(text, "notice problem", 30_000);
  }

  /** Shows work that takes a while, until it ends. */
  progress(text: string, cancel: () => void): ProgressNotice {
    const bar = element("progress", { max: "1", value: "0", "aria-label": text });
    const share = element("small", {}, "0 %");
    const stop = element("button", { class: "button", type: "button" }, "Cancel");
    stop.addEventListener("click", cancel);
    const notice = element("div", { class: "notice working" }, element("span", {}, text), share, bar, stop);
    this._list.append(notice);
    return {
      show(part) {
        bar.value = part;
        setText(share, part < 1 ? `${Math.floor(part * 100)} %` : "Reading");
      },
      end: () => notice.remove(),
    };
  }

  /** Runs a request, and shows its error as a problem. */
  async attempt<T>(work: () => Promise<T>): Promise<T | undefined> {
    try {
      return await work();
    } catch (error) {
      if ((error as Error).name !== "AbortError")
        this.problem((error as Error).message);
      return undefined;
    }
  }

  private _show(text: string, kind: string, milliseconds: number): void {
    for (const other of [...this._list.children]) {
      if (other.firstChild?.textContent === text)
        other.remove();
    }

    const close = element("button", { class: "plain", "aria-label": "Close", type: "button" }, "✕");
    const notice = element("div", { class: kind }, element("span", {}, text), close);
    close.addEventListener("click", () => notice.remove());
    this._list.append(notice);
    setTimeout(() => notice.remove(), milliseconds);
  }
}
