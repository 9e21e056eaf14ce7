import type { Characters, Page } from "../page/page";

/** Characters dropped on the page, and how they move. */
export function createCharacters(_page: Page): Characters {
  return { joints: () => ({}) };
}
