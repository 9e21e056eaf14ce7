import { Group } from "three";
import { Body } from "./body";
import { ContactMarks } from "./contacts";
import type { Stage } from "./stage";
import { Sticks } from "./sticks";

/** Compiles what the first picture of a performer needs while the page waits for the motion. */
export function warmUp(stage: Stage): void {
  const body = new Body({ key: "", name: "", index: -1, colour: "", variant: "Neck1", bones: [{ name: "Hips", parent: null, offset: [0, 1, 0] }] });
  const sticks = new Sticks(body, "white", stage.isSoftware);
  const contacts = new ContactMarks(body, "white");
  // These materials are kept, because the programs of the graphics card live as long as a material that uses them.
  void stage.prepare(new Group().add(sticks.group, ...contacts.meshes));
}
