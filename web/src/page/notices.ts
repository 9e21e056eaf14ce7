import { element } from "./dom";

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

  /** Runs a request, and shows its error as a problem. */
  async attempt<T>(work: () => Promise<T>): Promise<T | undefined> {
    try {
      return await work();
    } catch (error) {
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
