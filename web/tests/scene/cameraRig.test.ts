import assert from "node:assert/strict";
import { test } from "node:test";
import { PerspectiveCamera, Vector3 } from "three";
import { CameraRig } from "../../src/scene/cameraRig";

function seen(camera: PerspectiveCamera, x: number, y: number, z: number): Vector3 {
  camera.updateMatrixWorld();
  return new Vector3(x, y, z).project(camera);
}

test("from the front, the performer's left is at the right of the picture", () => {
  const camera = new PerspectiveCamera(35, 1);
  const rig = new CameraRig(camera);
  rig.lookFrom(0, 0, true);
  rig.jump();
  assert.ok(seen(camera, 0.5, 1, 0).x > 0);
  assert.ok(seen(camera, 0, 1.8, 0).y > 0);
});

test("from above, the performer's front is at the bottom of the picture", () => {
  const camera = new PerspectiveCamera(35, 1);
  const rig = new CameraRig(camera);
  rig.lookFrom(0, Math.PI / 2, true);
  rig.jump();
  assert.ok(seen(camera, 0, 1, 0.5).y < 0);
});

test("a flat view shows the target as large as a perspective view", () => {
  const camera = new PerspectiveCamera(35, 1);
  const rig = new CameraRig(camera);
  rig.lookFrom(0, 0, false);
  rig.jump();
  const perspective = seen(camera, 0, 1.5, 0).y;
  rig.lookFrom(0, 0, true);
  rig.jump();
  assert.ok(Math.abs(seen(camera, 0, 1.5, 0).y - perspective) < 1e-3);
});

test("dragging the picture moves the target with the pointer", () => {
  for (const yaw of [0, 1, 2.5]) {
    const camera = new PerspectiveCamera(35, 1);
    const rig = new CameraRig(camera);
    rig.lookFrom(yaw, 0.2, false);
    rig.jump();
    const point = rig.target.clone();
    rig.pan(-0.1, 0.05);
    rig.jump();
    const after = point.project(camera);
    assert.ok(Math.abs(after.x - 0.2) < 0.02 && Math.abs(after.y + 0.1) < 0.02, `${after.x} ${after.y}`);
  }
});

test("the camera settles, and then no picture is needed", () => {
  const rig = new CameraRig(new PerspectiveCamera(35, 1));
  rig.turn(1, 0.2);
  let pictures = 0;
  while (rig.update(16) && pictures < 1000)
    pictures++;
  assert.ok(pictures > 5 && pictures < 300);
  assert.equal(rig.update(16), false);
});

test("turning to a view takes the shorter way", () => {
  const rig = new CameraRig(new PerspectiveCamera(35, 1));
  rig.turn(5 * Math.PI, 0);
  rig.jump();
  rig.lookFrom(0, 0, true);
  assert.ok(Math.abs(rig.shownYaw) <= Math.PI + 1e-9);
});
