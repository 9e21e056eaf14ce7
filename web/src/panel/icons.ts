// Drawn on a grid of 20 points, with lines of 1.6 points.
const Paths = {
  orbit: "M10 4.2a5.8 5.8 0 1 0 0 11.6 5.8 5.8 0 0 0 0-11.6M2.6 10c0-1.7 3.3-3 7.4-3s7.4 1.3 7.4 3-3.3 3-7.4 3-7.4-1.3-7.4-3",
  front: "M4 4h12v12H4zM8 8h4v4H8z",
  side: "M4 6.5 10 4v12l-6-2.5zM10 4l6 2.5v7L10 16",
  top: "M10 3.5 17 7l-7 3.5L3 7zM3 11l7 3.5 7-3.5",
  follow: "M10 6.2a3.8 3.8 0 1 0 0 7.6 3.8 3.8 0 0 0 0-7.6M10 2v3M10 15v3M2 10h3M15 10h3",
  figure: "M10 2.6a2 2 0 1 0 0 4 2 2 0 0 0 0-4M5 8.4c3 .8 7 .8 10 0M10 9v3.4M10 12l-2.6 5.4M10 12l2.6 5.4",
  sticks: "M5 15.5 9 9l6-4.5M9 9l5.5 6M5 15.5h.01M9 9h.01M15 4.5h.01M14.5 15h.01",
  axes: "M5 15V4M5 15h11M5 15l5-5M3.4 5.6 5 4l1.6 1.6M14.4 13.4 16 15l-1.6 1.6",
  trails: "M3 15c3 0 3-9 7-9s3 5 7 4M14.6 7.8 17 10l-2.6 1.8",
  contacts: "M3 16h14M7 13V6.5a2 2 0 0 1 4 0V10l3.6 1.4a1.6 1.6 0 0 1 1 1.6z",
  names: "M3 5.5h14v7h-6L8 15.5v-3H3z",
  mirror: "M10 3v14M7.5 6 3 14h4.5zM12.5 6 17 14h-4.5z",
  record: "M10 5.2a4.8 4.8 0 1 0 0 9.6 4.8 4.8 0 0 0 0-9.6",
  stop: "M6 6h8v8H6z",
  zero: "M10 2.6a2 2 0 1 0 0 4 2 2 0 0 0 0-4M3 8.6h14M10 8.6v4M10 12.6 8 17.4M10 12.6l2 4.8",
  diagnose: "M3 10h3l2-5 3.4 10 2-5H17",
  open: "M3 6V4.5h5l1.6 1.8H17V15.5H3zM10 14V9M7.8 11 10 8.8l2.2 2.2",
  download: "M10 3.5v8.6M6.6 9 10 12.3 13.4 9M4 16h12",
  theme: "M10 3.4a6.6 6.6 0 1 0 0 13.2zM10 3.4a6.6 6.6 0 0 1 0 13.2",
  help: "M7.4 7.4a2.7 2.7 0 1 1 3.9 2.5c-.9.5-1.3 1-1.3 2M10 14.6h.01",
  panel: "M3 4.5h14v11H3zM12.4 4.5v11",
  eye: "M2.6 10S5.2 5 10 5s7.4 5 7.4 5-2.6 5-7.4 5-7.4-5-7.4-5M10 8a2 2 0 1 0 0 4 2 2 0 0 0 0-4",
  hidden: "M3.4 3.4l13.2 13.2M6.4 6.2C4 7.6 2.6 10 2.6 10S5.2 15 10 15c1.4 0 2.6-.4 3.6-1M8.4 5.1A8 8 0 0 1 10 5c4.8 0 7.4 5 7.4 5a13 13 0 0 1-1.7 2.3",
  close: "M5 5l10 10M15 5 5 15",
  play: "M6.5 4.2v11.6l9-5.8z",
  pause: "M6.8 4.5v11M13.2 4.5v11",
  first: "M5 4.5v11M15 4.8 8 10l7 5.2z",
  back: "M12.5 5 7 10l5.5 5",
  next: "M7.5 5 13 10l-5.5 5",
  loop: "M6 6.5h6.5a3.5 3.5 0 0 1 0 7H6M8.2 11.3 6 13.5l2.2 2.2",
  in: "M11 4H7v12h4",
  out: "M9 4h4v12H9",
  clear: "M8 4.5H5v11h3M12 4.5h3v11h-3M8.4 8.4l3.2 3.2M11.6 8.4l-3.2 3.2",
  plot: "M3.5 4v12h13M6 12.5l3-4 2.6 2.4L16 5.5",
  live: "M10 8.4a1.6 1.6 0 1 0 0 3.2 1.6 1.6 0 0 0 0-3.2M6.4 6.4a5 5 0 0 0 0 7.2M13.6 6.4a5 5 0 0 1 0 7.2M4 4a8.5 8.5 0 0 0 0 12M16 4a8.5 8.5 0 0 1 0 12",
} as const;

export type IconName = keyof typeof Paths;

const Namespace = "http://www.w3.org/2000/svg";

/** An icon in the colour of the text. Screen readers skip it. */
export function icon(name: IconName): SVGSVGElement {
  const svg = document.createElementNS(Namespace, "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("class", "icon");
  svg.setAttribute("data-icon", name);
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(Namespace, "path");
  path.setAttribute("d", Paths[name]);
  svg.append(path);
  return svg;
}

/** Replaces the icon of a button. */
export function setIcon(button: Element, name: IconName): void {
  const old = button.querySelector("svg");
  if (old?.dataset.icon !== name)
    old?.replaceWith(icon(name));
}
