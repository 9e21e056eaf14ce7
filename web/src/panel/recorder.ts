import { element, setText } from "../page/dom";
import type { Recording } from "../live/messages";
import type { Page, Takes } from "../page/page";
import { setPressed, wordButton } from "./buttons";
import { downloadButtons, Whole } from "./downloads";
import { bytes, duration } from "./format";
import { setIcon } from "./icons";

/** The button that records the stream, and what has been recorded. */
export class Recorder {
  readonly button: HTMLButtonElement;
  private readonly _page: Page;
  private readonly _takes: Takes;
  private readonly _words: HTMLElement;
  private readonly _line = element("p", { class: "recording" });
  private readonly _finished = element("ul", { class: "finished" });
  private readonly _known = new Set<string>();
  private _isRecording = false;

  constructor(page: Page, takes: Takes, place: HTMLElement) {
    this._page = page;
    this._takes = takes;
    this.button = wordButton("record", "Record", () => void this.toggle());
    this.button.classList.add("record-button");
    this.button.title = "Record the stream (r)";
    this._words = this.button.querySelector("span")!;
    this._line.hidden = true;
    place.append(this._line, this._finished);
    page.keys.add({ key: "r", does: "Start or stop recording", group: "Stream", isUseful: () => page.connection.hasStream, run: () => void this.toggle() });
  }

  async toggle(): Promise<void> {
    if (this.button.disabled)
      return;

    this.button.disabled = true;
    const action = this._isRecording ? "stop" : "start";
    await this._page.notices.attempt(() => this._page.api.change("POST", "record", { action }));
    this.button.disabled = false;
  }

  /** Forgets the recordings. The program tells its own after each hello. */
  clear(): void {
    this._isRecording = false;
    this._known.clear();
    this._finished.replaceChildren();
  }

  show(recording: Recording): void {
    const wasRecording = this._isRecording;
    this._isRecording = recording.state === "recording";
    const file = fileName(recording.file);
    this.button.classList.toggle("on", this._isRecording);
    setPressed(this.button, this._isRecording);
    setIcon(this.button, this._isRecording ? "stop" : "record");
    setText(this._words, this._isRecording ? duration(recording.seconds) : "Record");
    this.button.setAttribute("aria-label", this._isRecording ? "Stop the recording" : "Record");
    this._line.hidden = !this._isRecording;
    setText(this._line, `Recording ${file}, ${bytes(recording.bytes)}`);
    if (!this._isRecording && file !== "" && !this._known.has(file))
      this._add(file, recording);
    if (wasRecording && !this._isRecording && file !== "")
      this._page.notices.say(`Saved ${file}.`);
  }

  private _add(file: string, recording: Recording): void {
    this._known.add(file);
    const hasMotion = recording.frames > 0;
    const figures = element("small", {}, [duration(recording.seconds), bytes(recording.bytes), ...hasMotion ? [] : ["no motion"]].join(" · "));
    const line = element("li", {}, element("span", { class: "name" }, file, figures));
    this._finished.prepend(line);
    const take = recording.take;
    if (!take)
      return;

    if (hasMotion)
      line.append(wordButton("open", "Show", () => void this._page.notices.attempt(() => this._takes.open(take))), downloadButtons(this._page, take, file));
    else
      line.append(downloadButtons(this._page, take, file, Whole, ["nmrec"]));
  }
}

function fileName(path: string | null | undefined): string {
  return path?.split(/[/\\]/).at(-1) ?? "";
}
