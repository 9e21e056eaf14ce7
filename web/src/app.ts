import { connection } from "./live/program";
import { element } from "./page/dom";
import { describeMissing } from "./page/scripts";

// The program answers while the browser reads and compiles the rest of the page.
connection.connect();
import("./main").catch((error: unknown) => {
  console.error(error);
  explain();
});

// The program ended between two scripts. A page that fails for another reason must not load again and again, so it waits for an end of the program.
function explain(): void {
  const words = element("p", { role: "status" });
  document.body.replaceChildren(element("div", { class: "overlay" }, words));
  let wasGone = false;
  const update = (): void => {
    wasGone ||= connection.state === "gone";
    if (wasGone && connection.state === "open")
      location.reload();
    words.textContent = describeMissing(connection.state);
  };
  connection.onState(update);
  update();
}
