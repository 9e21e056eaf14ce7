import { element } from "../page/dom";
import type { Page } from "../page/page";
import { wordButton } from "./buttons";
import { copyText } from "./copy";
import { openDialog } from "./dialog";

interface Diagnosis {
  readonly lines: readonly string[];
  readonly verdict?: string | null;
}

/** The button that asks for the diagnosis of the stream, and shows it. */
export function createDiagnosisButton(page: Page): HTMLButtonElement {
  const button = wordButton("diagnose", "Diagnose", () => void diagnose());
  button.title = "Find out what is wrong with the stream (g)";
  page.keys.add({ key: "g", does: "Diagnose the stream", group: "Stream", isUseful: () => page.connection.hasStream, run: () => button.click() });
  return button;

  async function diagnose(): Promise<void> {
    button.disabled = true;
    button.classList.add("busy");
    const diagnosis = await page.notices.attempt(() => page.api.change<Diagnosis>("POST", "diagnose"));
    button.disabled = false;
    button.classList.remove("busy");
    if (diagnosis)
      show(diagnosis);
  }
}

function show(diagnosis: Diagnosis): void {
  const text = diagnosis.lines.join("\n");
  const copy = element("button", { type: "button", class: "button" }, "Copy");
  copy.addEventListener("click", async () => {
    copy.textContent = await copyText(text, dialog) ? "Copied" : "Select the text and copy it";
  });
  const verdict = diagnosis.verdict ? [element("p", { class: "verdict" }, diagnosis.verdict)] : [];
  const dialog = openDialog("Diagnosis", ...verdict, element("pre", { tabindex: "0", "aria-label": "Report" }, text), element("div", { class: "answers" }, copy));
}
