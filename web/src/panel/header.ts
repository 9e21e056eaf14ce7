import { element, setText } from "../page/dom";
import type { Drops } from "../page/drops";
import type { Keys } from "../page/keys";
import type { Settings, SettingsStore } from "../page/settings";
import { iconButton, setPressed, wordButton } from "./buttons";
import { showHelp } from "./help";
import type { Situation } from "./situation";

const Themes: readonly Settings["theme"][] = ["system", "dark", "light"];

/** The bar at the top: source and state, actions, and settings of the page. */
export class Header {
  /** Holds the actions on the stream. */
  readonly actions = element("div", { class: "actions", role: "group", "aria-label": "Stream" });
  private readonly _dot = element("i", { class: "dot" });
  private readonly _state = element("span", { class: "state" });
  private readonly _source = element("span", { class: "source" });

  constructor(settings: SettingsStore, keys: Keys, drops: Drops) {
    const open = wordButton("open", "Open file", () => drops.choose());
    open.title = "Open a take or a character (o). Or drop it on the page.";
    const nextTheme = (): void => settings.change({ theme: Themes[(Themes.indexOf(settings.now.theme) + 1) % Themes.length] });
    const theme = iconButton("theme", "Theme", "d", nextTheme);
    const help = iconButton("help", "Keys", "?", () => showHelp(keys));
    const panel = iconButton("panel", "Panel", "p", () => settings.toggle("panel"));
    keys.add(
      { key: "o", does: "Open a file", group: "Page", run: () => drops.choose() },
      { key: "d", does: "Theme: system, dark or light", group: "Page", run: nextTheme },
      { key: "p", does: "Panel", group: "Page", run: () => settings.toggle("panel") },
      { key: "?", does: "This list", group: "Page", run: () => showHelp(keys) },
    );
    settings.watch(now => {
      theme.title = `Theme: ${now.theme} (d)`;
      theme.setAttribute("aria-label", `Theme: ${now.theme}`);
      setPressed(panel, now.panel);
      document.body.classList.toggle("with-panel", now.panel);
    });

    const stream = element("div", { class: "stream-state" }, this._dot, this._state, this._source);
    const page = element("div", { class: "actions", role: "group", "aria-label": "Page" }, theme, help, panel);
    document.body.prepend(element("header", { class: "bar" },
      element("h1", { class: "brand" }, "NeuronMocap"), stream, element("span", { class: "space" }), this.actions, open, page));
  }

  show(situation: Situation, source: string): void {
    this._dot.dataset.tone = situation.tone;
    setText(this._state, situation.title);
    setText(this._source, source);
  }
}
