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
    this._showFor(6000, text, "notice");
  }

  /** Shows what went wrong, until it is closed or half a minute has passed. */
  problem(text: string): void {
    this._showFor(30_000, text, "notice problem");
  }

  /** Removes a notice that no longer holds. */
  withdraw(text: string): void {
    for (const notice of [...this._list.children]) {
      if (notice.firstChild?.textContent === text)
        notice.remove();
    }
  }

  /** Shows a sentence with a button, until this button or the cross is pressed. */
  offer(text: string, word: string, run: () => void): void {
    const button = element("button", { class: "button", type: "button" }, word);
    const notice = this._show(text, "notice offer");
    notice.insertBefore(button, notice.lastChild);
    button.addEventListener("click", () => {
      notice.remove();
      run();
    });
  }

  /** Shows work that takes a while, until it ends. */
  progress(text: string, cancel: () => void): ProgressNotice {
    const bar = element("progress", { max: "1", value: "0", "aria-label": text });
    // The list is read aloud at each change.
    const share = element("small", { "aria-hidden": "true" }, "0 %");
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

  private _showFor(milliseconds: number, text: string, kind: string): void {
    const notice = this._show(text, kind);
    setTimeout(() => notice.remove(), milliseconds);
  }

  private _show(text: string, kind: string): HTMLElement {
    this.withdraw(text);
    const close = element("button", { class: "plain", "aria-label": "Close", type: "button" }, "✕");
    const notice = element("div", { class: kind }, element("span", {}, text), close);
    close.addEventListener("click", () => notice.remove());
    this._list.append(notice);
    return notice;
  }
}
