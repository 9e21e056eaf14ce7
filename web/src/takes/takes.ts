import type { Page, Takes } from "../page/page";

/** Recordings on the page: dropped files, the time line, and plots under it. */
export function createTakes(_page: Page): Takes {
  return {
    current: null,
    async open() {},
    close() {},
  };
}
