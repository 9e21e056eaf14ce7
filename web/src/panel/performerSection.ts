import { element, setText } from "../page/dom";
import type { PerformerRates, Status } from "../live/messages";
import type { Performer } from "../scene/performer";
import type { Performers } from "../scene/performers";
import type { Views } from "../scene/views";
import { iconButton, setPressed } from "./buttons";
import { count, milliseconds, short } from "./format";
import { setIcon } from "./icons";

/** The section of the panel that lists the performers. */
export class PerformerSection {
  private readonly _place: HTMLElement;
  private readonly _performers: Performers;
  private readonly _views: Views;
  private readonly _figures = new Map<string, HTMLElement>();
  private readonly _list = element("ul", { class: "performers" });
  private _status: Status | null = null;

  constructor(place: HTMLElement, performers: Performers, views: Views) {
    this._place = place;
    this._performers = performers;
    this._views = views;
    place.append(element("h2", {}, "Performers"), this._list);
    performers.onChange(() => this._rebuild());
    views.onChange(() => this._rebuild());
    this._rebuild();
  }

  show(status: Status | null): void {
    this._status = status;
    for (const [key, figures] of this._figures)
      setText(figures, describe(status?.performers.find(each => each.key === key)));
  }

  private _rebuild(): void {
    const focused = (document.activeElement as HTMLElement | null)?.dataset.id;
    this._place.hidden = this._performers.count === 0;
    this._figures.clear();
    this._list.replaceChildren(...[...this._performers.all].map(performer => this._row(performer)));
    this.show(this._status);
    if (focused)
      this._list.querySelector<HTMLElement>(`[data-id="${CSS.escape(focused)}"]`)?.focus();
  }

  private _row(performer: Performer): HTMLElement {
    const { key, name, colour } = performer.info;
    const words = name || key;
    const dot = element("i", { class: "colour" });
    dot.style.background = colour;
    const figures = element("small");
    this._figures.set(key, figures);
    const isFollowed = this._views.followed === key;
    const follow = iconButton("follow", `Follow ${words}`, "", () => this._views.follow(isFollowed ? null : key));
    setPressed(follow, isFollowed);
    follow.dataset.id = `follow ${key}`;
    const hide = iconButton("eye", `Show ${words}`, "", () => this._performers.setHidden(key, !performer.hidden));
    setPressed(hide, !performer.hidden);
    setIcon(hide, performer.hidden ? "hidden" : "eye");
    hide.dataset.id = `hide ${key}`;
    return element("li", {}, dot, element("span", { class: "name" }, words, figures), follow, hide);
  }
}

function describe(rates: PerformerRates | undefined): string {
  if (!rates)
    return "";

  const parts = [`${short(rates.fps)} fps`];
  if (rates.jitter !== null)
    parts.push(`jitter ${milliseconds(rates.jitter)}`);
  if (rates.lost > 0)
    parts.push(`${count(rates.lost)} lost`);
  return parts.join(" · ");
}
