import type { Page } from "../page/page";
import { wordButton } from "./buttons";
import { ask } from "./dialog";

const Question = "This resets the direction or the position of all avatars, for everybody who receives this stream. What exactly it resets "
  + "depends on the server.";

/** The button that zeroes out the avatars of the server. It asks first. */
export class ZeroOut {
  readonly button: HTMLButtonElement;

  constructor(page: Page) {
    this.button = wordButton("zero", "Zero out", () => void zeroOut());
    page.keys.add({ key: "z", does: "Zero out (asks first)", group: "Stream", isUseful: () => !this.button.disabled, run: () => this.button.click() });
    this.allow(false, false);

    async function zeroOut(): Promise<void> {
      if (!await ask("Zero out all avatars?", Question, "Zero out"))
        return;

      if (await page.notices.attempt(async () => (await page.api.change("POST", "zero-out", {})) ?? true))
        page.notices.say("The server has zeroed out the avatars.");
    }
  }

  /** Allows the command if the source of the stream takes commands, and is connected. */
  allow(canCommand: boolean, isConnected: boolean): void {
    this.button.disabled = !canCommand || !isConnected;
    this.button.title = !canCommand ? "This source takes no commands."
      : isConnected ? "Reset the direction or the position of all avatars (z)" : "The source is not connected.";
  }
}
