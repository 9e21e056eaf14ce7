import type { Page } from "../page/page";
import { wordButton } from "./buttons";
import { ask } from "./dialog";

const Question = "This resets the direction or the position of all avatars, for everybody who receives this stream. What exactly it resets "
  + "depends on the server.";

/** The button that zeroes out the avatars of the server, after a question. */
export class ZeroOut {
  readonly button: HTMLButtonElement;

  constructor(page: Page) {
    this.button = wordButton("zero", "Zero out", () => void zeroOut());
    page.keys.add({ key: "z", does: "Zero out, after a question", group: "Stream", isUseful: () => !this.button.disabled, run: () => this.button.click() });
    this.allow(false);

    async function zeroOut(): Promise<void> {
      if (!await ask("Zero out all avatars?", Question, "Zero out"))
        return;

      if (await page.notices.attempt(async () => (await page.api.change("POST", "zero-out", {})) ?? true))
        page.notices.say("The server has zeroed out the avatars.");
    }
  }

  /** The source of the stream takes commands, or does not. */
  allow(canCommand: boolean): void {
    this.button.disabled = !canCommand;
    this.button.title = canCommand ? "Reset the direction or the position of all avatars (z)" : "This source takes no commands.";
  }
}
