const Steps: Readonly<Record<string, number>> = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 };

/**
 * Makes one tab stop of a toolbar. The arrow keys move between its buttons, and Home and End to its ends. A list keeps its own keys. After a
 * click, the keys are those of the page.
 */
export function addToolbarKeys(bar: HTMLElement): void {
  const items = (): HTMLElement[] => [...bar.querySelectorAll<HTMLElement>("button:not([disabled]), select")];
  const hold = (item: HTMLElement | undefined): void => {
    for (const other of bar.querySelectorAll<HTMLElement>("button, select"))
      other.tabIndex = other === item ? 0 : -1;
  };
  hold(items()[0]);
  new MutationObserver(() => {
    if (!items().some(item => item.tabIndex === 0))
      hold(items()[0]);
  }).observe(bar, { subtree: true, attributeFilter: ["disabled"] });
  let isClicked = false;
  bar.addEventListener("pointerdown", () => {
    isClicked = true;
  });
  bar.addEventListener("focusout", event => {
    isClicked &&= bar.contains(event.relatedTarget as Node | null);
  });
  const leave = (): void => {
    if (isClicked && bar.contains(document.activeElement))
      (document.activeElement as HTMLElement).blur();
    isClicked = false;
  };
  bar.addEventListener("click", event => {
    if (!(event.target instanceof HTMLSelectElement))
      leave();
  });
  bar.addEventListener("change", leave);
  bar.addEventListener("focusin", event => hold((event.target as HTMLElement).closest<HTMLElement>("button, select") ?? undefined));
  bar.addEventListener("keydown", event => {
    const all = items();
    const next = placeAfter(event.key, all.indexOf(event.target as HTMLElement), all.length);
    const isOfList = event.target instanceof HTMLSelectElement && event.key !== "ArrowLeft" && event.key !== "ArrowRight";
    if (next < 0 || isClicked || isOfList || event.ctrlKey || event.altKey || event.metaKey)
      return;

    event.preventDefault();
    event.stopPropagation();
    all[next].focus();
  });
}

/** The place that a key leads to, or -1. Behind the last one is the first one. */
export function placeAfter(key: string, place: number, count: number): number {
  if (place < 0)
    return -1;
  if (key === "Home")
    return 0;
  if (key === "End")
    return count - 1;

  const step = Steps[key];
  return step === undefined ? -1 : (place + step + count) % count;
}
