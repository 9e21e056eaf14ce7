import { connection } from "./live/program";
import { element } from "./page/dom";
import { describeMissing } from "./page/scripts";

const WithoutWebGl = "This browser cannot draw in three dimensions (WebGL 2). Turn on hardware acceleration, or use another browser.";

// The program answers while the browser reads and compiles the rest of the page.
connection.connect();
import("./main").catch((error: unknown) => {
  console.error(error);
  explain();
});

// The browser cannot draw, or the program ended between two scripts. A page that fails for another reason must not load again and again, so it waits
// for an end of the program.
function explain(): void {
  const words = element("p", { role: "status" });
  document.body.replaceChildren(element("div", { class: "overlay" }, words));
  const canDraw = element("canvas").getContext("webgl2") !== null;
  let wasGone = false;
  const update = (): void => {
    wasGone ||= connection.state === "gone";
    if (wasGone && connection.state === "open")
      location.reload();
    words.textContent = canDraw ? describeMissing(connection.state) : WithoutWebGl;
  };
  connection.onState(update);
  update();
}
