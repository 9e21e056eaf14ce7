import assert from "node:assert/strict";
import { test } from "node:test";
import { PerspectiveCamera } from "three";
import { CameraRig } from "../../src/scene/cameraRig";
import type { Performers } from "../../src/scene/performers";
import { PlaceWidth } from "../../src/scene/performer";
import type { Stage } from "../../src/scene/stage";
import { Views } from "../../src/scene/views";

interface Person { key: string; x: number; z: number; isOnStage: boolean; placesBeside: number; body: { offsets: number[] } }

function person(key: string, x: number, z = 0): Person {
  return { key, x, z, isOnStage: true, placesBeside: 0, body: { offsets: [0, 1, 0] } };
}

function createViews(...people: Person[]) {
  const camera = new PerspectiveCamera(35, 4 / 3);
  const rig = new CameraRig(camera);
  const stage = { camera, floor: { moveTo: () => {} }, lights: { cover: () => {} } };
  const performers = { all: people, get: (key: string) => people.find(each => each.key === key) };
  const views = new Views(rig, performers as unknown as Performers, stage as unknown as Stage);
  const update = () => {
    views.update(true);
    rig.jump();
  };
  update();

  // Whether a point of the floor is in the picture.
  const sees = (x: number, z = 0) => {
    const point = rig.target.clone().set(x, 1, z).project(camera);
    return Math.abs(point.x) < 1 && Math.abs(point.y) < 1;
  };
  return { views, rig, update, sees };
}

test("the camera looks at the middle of what is shown, not of the hidden", () => {
  const people = [person("a", 0), person("b", 30), person("c", 2)];
  const { views, rig, update } = createViews(...people);
  assert.equal(rig.target.x, 15);
  people[1].isOnStage = false;
  update();
  assert.equal(rig.target.x, 1);
  views.follow("b");
  assert.equal(rig.target.x, 1);
});

test("characters beside a performer are in the picture", () => {
  const people = [person("a", 0)];
  const { views, update, sees } = createViews(...people);
  for (const followed of [null, "a"]) {
    people[0].placesBeside = 0;
    views.follow(followed);
    update();
    assert.ok(!sees(3 * PlaceWidth));
    people[0].placesBeside = 3;
    update();
    assert.ok(sees(-0.5) && sees(3 * PlaceWidth + 0.5));
  }
});

test("the camera goes back while performers walk apart, and stays there when they meet again", () => {
  const people = [person("a", -1), person("b", 1)];
  const { rig, update, sees } = createViews(...people);
  for (let step = 0; step < 100; step++) {
    people[0].x -= 0.05;
    people[1].z += 0.05;
    update();
    assert.ok(sees(people[0].x, people[0].z) && sees(people[1].x, people[1].z), `${step}`);
  }

  const { distance } = rig;
  people[0].x = -1;
  people[1].z = 0;
  update();
  assert.equal(rig.distance, distance);
});

test("a hand that came closer stays closer while performers walk apart", () => {
  const people = [person("a", -1), person("b", 1)];
  const { rig, update } = createViews(...people);
  const { distance } = rig;
  rig.zoom(0.5);
  people[1].x += 0.1;
  update();
  assert.ok(rig.distance < distance * 0.6);
});
