import assert from "node:assert/strict";
import { test } from "node:test";
import { type Mesh, type MeshBasicMaterial, Vector2 } from "three";
import { Pose } from "../../src/live/pose";
import type { Settings } from "../../src/page/settings";
import { Body } from "../../src/scene/body";
import { ContactMarks } from "../../src/scene/contacts";
import { Performer } from "../../src/scene/performer";
import { performer } from "../performers";

const Picture = 1000 / 60;
const Second = 60;

function createMarks(): ContactMarks {
  const info = performer();
  const names = ["LeftFoot", "RightFoot"];
  return new ContactMarks(new Body({ ...info, bones: info.bones.map((bone, i) => i < 2 ? bone : { ...bone, name: names[i - 2] ?? bone.name }) }), info.colour);
}

const opacity = (mesh: Mesh): number => (mesh.material as MeshBasicMaterial).opacity;

// Pictures that a second of updates asks for.
function countPictures(update: (step: number) => boolean): number {
  let pictures = 0;
  for (let i = 0; i < Second; i++)
    pictures += update(Picture) ? 1 : 0;
  return pictures;
}

test("the marks of feet that stand become steady, and then no picture is needed", () => {
  const marks = createMarks();
  const update = (step: number): boolean => marks.update(step, true);
  assert.equal(countPictures(update), 0);
  marks.set(true, false);
  const fading = countPictures(update);
  assert.ok(fading > 0 && fading < 10, `${fading}`);
  const [left, right] = marks.meshes;
  const steady = opacity(left);
  assert.ok(steady > 0 && left.visible && !right.visible);
  assert.equal(countPictures(update), 0);
  assert.equal(opacity(left), steady);

  marks.set(false, false);
  const gone = countPictures(update);
  assert.ok(gone > 0 && gone < 20, `${gone}`);
  assert.ok(!left.visible);
  assert.equal(countPictures(update), 0);
});

test("marks that nobody sees need no picture", () => {
  const marks = createMarks();
  marks.set(true, true);
  assert.equal(countPictures(step => marks.update(step, false)), 0);

  const settings = { look: "sticks", axes: false, trails: false, contacts: true } as Settings;
  const shown = new Performer(performer(), new Vector2(), false);
  shown.setContacts(true, true);
  assert.equal(countPictures(step => shown.update(settings, step)), 0, "without a pose");
  shown.show(new Pose());
  shown.hidden = true;
  shown.update(settings, Picture);
  shown.setContacts(false, false);
  assert.equal(countPictures(step => shown.update(settings, step)), 0, "hidden");
});
