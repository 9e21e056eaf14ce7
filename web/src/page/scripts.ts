import type { ConnectionState } from "../live/connection";

/** What to tell if a script of the page cannot be loaded. */
export function describeMissing(connection: ConnectionState): string {
  // The scripts have other names in another version of the page.
  return connection === "open" || connection === "denied"
    ? "This page is older than the program. Reload it."
    : "The program does not answer. Load the page again once it runs.";
}
