import { element, setText } from "../page/dom";
import type { Keys, Shortcut } from "../page/keys";
import { iconButton, setPressed } from "../panel/buttons";
import { setIcon } from "../panel/icons";
import { addToolbarKeys } from "../panel/toolbarKeys";
import { type Playback, Speeds } from "./playback";
import { clock } from "./ticks";

/** What the buttons and keys of the time line do besides playing. */
export interface TransportActions {
  /** Shows the next or the previous frame. */
  step(direction: number): void;
  seek(time: number): void;
  togglePlot(): void;
  showAll(): void;
}

const Second = 1000;

/** Buttons to play, step and choose a part, and the time in seconds and frames. */
export class Transport {
  readonly element = element("div", { class: "transport", role: "toolbar", "aria-label": "Playback" });
  private readonly _playback: Playback;
  private readonly _actions: TransportActions;
  private readonly _play: HTMLButtonElement;
  private readonly _loop: HTMLButtonElement;
  private readonly _plot: HTMLButtonElement;
  private readonly _part: HTMLButtonElement;
  private readonly _speed = element("select", { "aria-label": "Speed", title: "Speed (< and >)" });
  private readonly _time = element("output", { class: "time", "aria-label": "Time" });
  private readonly _length = element("span", { class: "length" });
  private readonly _frame = element("span", { class: "frame" });

  constructor(playback: Playback, actions: TransportActions) {
    this._playback = playback;
    this._actions = actions;
    this._play = iconButton("play", "Play", "Space", () => playback.toggle());
    this._play.classList.add("play");
    this._loop = iconButton("loop", "Loop", "l", () => playback.toggleLoop());
    this._plot = iconButton("plot", "Plot", "v", () => actions.togglePlot());
    this._part = iconButton("clear", "Play the whole take", "x", () => playback.clearPart());
    for (const speed of Speeds)
      this._speed.append(element("option", { value: String(speed) }, `${speed}×`));
    this._speed.addEventListener("change", () => playback.setSpeed(Number(this._speed.value)));
    this.element.append(
      element("div", { class: "tools-row" },
        iconButton("first", "To the start", "Home", () => actions.seek(playback.start)),
        iconButton("back", "Frame back", ",", () => actions.step(-1)),
        this._play,
        iconButton("next", "Frame forward", ".", () => actions.step(1)),
        this._loop),
      element("div", { class: "readout" }, this._time, this._length, this._frame),
      element("div", { class: "tools-row" },
        iconButton("in", "Start of the part", "[", () => playback.setFrom(playback.time)),
        iconButton("out", "End of the part", "]", () => playback.setTo(playback.time)),
        this._part, this._speed, this._plot));
    addToolbarKeys(this.element);
    this.refresh();
  }

  /** Adds the keys. Returns a function that removes them. */
  addKeys(keys: Keys): () => void {
    const { _playback: playback, _actions: actions } = this;
    const key = (name: string, does: string, run: () => void, label?: string): Shortcut => ({ key: name, does, run, label, group: "Take" });
    const step = (name: string, does: string, run: () => void): Shortcut => ({ ...key(name, does, run), repeats: true });
    return keys.add(
      key(" ", "Play, and stop", () => playback.toggle(), "Space"),
      step(",", "Frame back", () => actions.step(-1)),
      step(".", "Frame forward", () => actions.step(1)),
      step("PageUp", "A second back", () => actions.seek(playback.time - Second)),
      step("PageDown", "A second forward", () => actions.seek(playback.time + Second)),
      key("Home", "To the start", () => actions.seek(playback.start)),
      key("End", "To the end", () => {
        playback.pause();
        actions.seek(playback.end);
      }),
      key("<", "Slower", () => playback.changeSpeed(-1)),
      key(">", "Faster", () => playback.changeSpeed(1)),
      key("l", "Loop", () => playback.toggleLoop()),
      key("[", "Start of the part", () => playback.setFrom(playback.time)),
      key("]", "End of the part", () => playback.setTo(playback.time)),
      key("x", "Play the whole take", () => playback.clearPart()),
      key("w", "Whole time line", () => actions.showAll()),
      key("v", "Plot", () => actions.togglePlot()));
  }

  /** Shows the state of the playback. */
  refresh(): void {
    const playback = this._playback;
    const words = playback.playing ? "Stop" : "Play";
    setIcon(this._play, playback.playing ? "pause" : "play");
    this._play.setAttribute("aria-label", words);
    this._play.title = `${words} (Space)`;
    setPressed(this._loop, playback.loop);
    this._part.disabled = playback.from === null && playback.to === null;
    this._speed.value = String(playback.speed);
    setText(this._length, `/ ${clock(playback.duration)}`);
  }

  setPlot(visible: boolean): void {
    setPressed(this._plot, visible);
  }

  /** @param frame Number of the frame from 0, or -1 if it is not known. */
  showTime(time: number, frame: number, frames: number, isGap: boolean): void {
    setText(this._time, clock(time));
    setText(this._frame, frames === 0 ? "no frames" : isGap ? "gap" : `frame ${frame < 0 ? "…" : frame + 1} of ${frames}`);
  }
}
