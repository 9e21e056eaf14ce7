import { element } from "../page/dom";
import { iconButton } from "./buttons";

/** Shows a dialog with a title. Escape and a click outside close it; the focus returns to where it was. */
export function openDialog(title: string, ...content: readonly (Node | string)[]): HTMLDialogElement {
  const dialog = element("dialog", { "aria-label": title });
  const close = iconButton("close", "Close", "", () => dialog.close());
  dialog.append(element("header", {}, element("h2", {}, title), close), element("div", { class: "content" }, ...content));
  dialog.addEventListener("click", event => {
    if (event.target === dialog)
      dialog.close();
  });
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}

/** Asks a question. The answer is true only if the reader presses the button with the word. */
export function ask(title: string, text: string, word: string): Promise<boolean> {
  return new Promise(resolve => {
    let answer = false;
    const no = element("button", { type: "button", class: "button" }, "Cancel");
    const yes = element("button", { type: "button", class: "button main" }, word);
    const dialog = openDialog(title, element("p", {}, text), element("div", { class: "answers" }, no, yes));
    dialog.classList.add("question");
    no.addEventListener("click", () => dialog.close());
    yes.addEventListener("click", () => {
      answer = true;
      dialog.close();
    });
    dialog.addEventListener("close", () => resolve(answer));
    no.focus();
  });
}
