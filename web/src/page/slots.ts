import { element } from "./dom";

/** Places of the document. An empty place takes no room. */
export interface Slots {
  /** Holds the canvas and what lies over it. */
  readonly stage: HTMLElement;
  /** The tools over the edge of the stage, or below it on a phone. */
  readonly tools: HTMLElement;
  /** Across the bottom: the time line of a take. */
  readonly timeline: HTMLElement;
  /** Sections of the panel at the side. */
  readonly stream: HTMLElement;
  readonly performers: HTMLElement;
  readonly take: HTMLElement;
  readonly characters: HTMLElement;
}

export function createSlots(): Slots {
  const slots = {
    stage: element("div", { class: "stage" }),
    tools: element("div", { class: "toolbar", role: "toolbar", "aria-label": "View", "aria-orientation": "vertical" }),
    timeline: element("section", { class: "timeline", "aria-label": "Time line" }),
    stream: element("section", { class: "section" }),
    performers: element("section", { class: "section" }),
    take: element("section", { class: "section" }),
    characters: element("section", { class: "section" }),
  };
  const panel = element("aside", { class: "panel", "aria-label": "Panel" }, slots.stream, slots.performers, slots.take, slots.characters);
  document.body.append(element("main", { "aria-label": "Stage" }, slots.stage, slots.tools), panel, slots.timeline);
  return slots;
}
