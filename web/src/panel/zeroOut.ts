import type { Page } from "../page/page";
import { wordButton } from "./buttons";
import { ask } from "./dialog";

const Question = "The server moves every avatar to the origin, for everybody who receives this stream. The performers should stand in the pose that "
  + "the server asks for.";

/** The button that moves the avatars of the server to the origin, after a question. */
export class ZeroOut {
  readonly button: HTMLButtonElement;

  constructor(page: Page) {
    this.button = wordButton("zero", "Zero out", () => void zeroOut());
    page.keys.add({ key: "z", does: "Zero out, after a question", group: "Stream", run: () => this.button.click() });
    this.allow(false);

    async function zeroOut(): Promise<void> {
      if (!await ask("Zero out all avatars?", Question, "Zero out"))
        return;

      if (await page.notices.attempt(async () => (await page.api.change("POST", "zero-out", {})) ?? true))
        page.notices.say("The avatars are at the origin.");
    }
  }

  /** The source of the stream takes commands, or does not. */
  allow(canCommand: boolean): void {
    this.button.disabled = !canCommand;
    this.button.title = canCommand ? "Move all avatars to the origin (z)" : "This source takes no commands.";
  }
}
