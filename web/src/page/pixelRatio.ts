/** Calls a function when the window comes to a screen with other pixels. A ResizeObserver does not notice that. */
export function watchPixelRatio(changed: () => void): void {
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
    watchPixelRatio(changed);
    changed();
  }, { once: true });
}
