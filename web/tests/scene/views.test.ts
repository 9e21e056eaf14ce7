import assert from "node:assert/strict";
import { test } from "node:test";
import { PerspectiveCamera, Vector3 } from "three";
import { CameraRig } from "../../src/scene/cameraRig";
import type { Performers } from "../../src/scene/performers";
import type { Stage } from "../../src/scene/stage";
import { Views } from "../../src/scene/views";

class Person {
  readonly hasPose = true;
  readonly body = { offsets: [0, 1, 0] };
  hidden = false;
  companions: Vector3[] = [];

  constructor(readonly key: string, public x: number, public z = 0) {}

  get isOnStage(): boolean {
    return !this.hidden;
  }
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
  const people = [new Person("a", 0), new Person("b", 30), new Person("c", 2)];
  const { views, rig, update } = createViews(...people);
  assert.equal(rig.target.x, 15);
  people[1].hidden = true;
  update();
  assert.equal(rig.target.x, 1);
  views.follow("b");
  assert.equal(rig.target.x, 1);
  people.forEach(each => { each.hidden = true; });
  update();
  assert.equal(rig.target.x, 1);
});

test("to hide and show a performer leaves the camera as near as it was moved", () => {
  const people = [new Person("a", -1), new Person("b", 1)];
  const { rig, update } = createViews(...people);
  rig.zoom(0.5);
  const { distance } = rig;
  for (const hidden of [true, false]) {
    people[1].hidden = hidden;
    update();
    assert.equal(rig.distance, distance);
  }
});

test("characters beside a performer are in the picture as soon as they have come", () => {
  for (const followed of [null, "a"]) {
    const people = [new Person("a", 0)];
    const { views, update, sees } = createViews(...people);
    views.follow(followed);
    const far = new Vector3(NaN, NaN, NaN);
    people[0].companions = [far];
    update();
    assert.ok(!sees(4, 1));
    far.set(4, 1, 1);
    update();
    assert.ok(sees(-0.5) && sees(4.5, 1));
  }
});

test("the camera does not jump when it follows again", () => {
  const people = [new Person("a", -1), new Person("b", 1)];
  const { rig, views, update } = createViews(...people);
  views.update(false);
  people[1].x = 9;
  views.update(false);
  const { distance } = rig;
  update();
  assert.equal(rig.distance, distance);
  people[1].x = 1e6;
  update();
  assert.ok(rig.distance <= 60);
});

test("the camera goes back while performers walk apart, and stays there when they meet again", () => {
  const people = [new Person("a", -1), new Person("b", 1)];
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

test("a camera that was moved closer stays closer while performers walk apart", () => {
  const people = [new Person("a", -1), new Person("b", 1)];
  const { rig, update } = createViews(...people);
  const { distance } = rig;
  rig.zoom(0.5);
  people[1].x += 0.1;
  update();
  assert.ok(rig.distance < distance * 0.6);
});
