import { Color, CylinderGeometry, Group, InstancedMesh, type Material, SphereGeometry } from "three";
import type { Body } from "./body";
import { createSolid } from "./materials";

const Thick = 0.016;
const Thin = 0.006;

// Tapered along +Y from 0 to 1.
const stickShape = new CylinderGeometry(0.45, 1, 1, 10, 1).translate(0, 0.5, 0);
const jointShape = new SphereGeometry(1, 12, 8);

/** The skeleton as sticks between joints. */
export class Sticks {
  readonly group = new Group();
  private readonly _body: Body;
  private readonly _sticks: InstancedMesh;
  private readonly _joints: InstancedMesh;
  private readonly _ends: readonly { readonly bone: number; readonly end: readonly [number, number, number] }[];

  constructor(body: Body, colour: string, isSoftware: boolean) {
    this._body = body;
    this._ends = endsOf(body);
    const base = new Color(colour);
    const material = createSolid(base, 0.6, isSoftware);
    const joint = createSolid(base.clone().lerp(new Color(1, 1, 1), 0.3), 0.5, isSoftware);
    this._sticks = new InstancedMesh(stickShape, material, body.names.length - 1 + this._ends.length);
    this._joints = new InstancedMesh(jointShape, joint, body.names.length);
    for (const mesh of [this._sticks, this._joints]) {
      mesh.castShadow = true;
      mesh.frustumCulled = false;
      this.group.add(mesh);
    }
  }

  update(): void {
    const { positions, rotations, parents } = this._body;
    const sticks = this._sticks.instanceMatrix.array as Float32Array;
    const joints = this._joints.instanceMatrix.array as Float32Array;
    for (let bone = 0; bone < parents.length; bone++) {
      const size = thicknessOf(bone);
      const at = bone * 16, p = bone * 3;
      joints[at] = joints[at + 5] = joints[at + 10] = size * 1.25;
      joints[at + 12] = positions[p];
      joints[at + 13] = positions[p + 1];
      joints[at + 14] = positions[p + 2];
      joints[at + 15] = 1;
      if (bone > 0) {
        const q = parents[bone] * 3;
        placeStick(sticks, (bone - 1) * 16, positions[q], positions[q + 1], positions[q + 2],
          positions[p] - positions[q], positions[p + 1] - positions[q + 1], positions[p + 2] - positions[q + 2], size);
      }
    }

    let next = (parents.length - 1) * 16;
    for (const { bone, end } of this._ends) {
      const p = bone * 3, r = bone * 4;
      const x = rotations[r], y = rotations[r + 1], z = rotations[r + 2], w = rotations[r + 3];
      const tx = 2 * (y * end[2] - z * end[1]), ty = 2 * (z * end[0] - x * end[2]), tz = 2 * (x * end[1] - y * end[0]);
      placeStick(sticks, next, positions[p], positions[p + 1], positions[p + 2],
        end[0] + w * tx + y * tz - z * ty, end[1] + w * ty + z * tx - x * tz, end[2] + w * tz + x * ty - y * tx, Thick);
      next += 16;
    }

    this._sticks.instanceMatrix.needsUpdate = true;
    this._joints.instanceMatrix.needsUpdate = true;
  }

  dispose(): void {
    this.group.removeFromParent();
    for (const mesh of [this._sticks, this._joints]) {
      (mesh.material as Material).dispose();
      mesh.dispose();
    }
  }
}

// Bones of the hands are thin: the order of the stream is the same in both variants.
function thicknessOf(bone: number): number {
  return bone >= 17 && bone <= 35 || bone >= 40 ? Thin : Thick;
}

// The stream does not carry the ends of the head and the feet. Those of the default body, at this body's size.
function endsOf(body: Body): { bone: number; end: readonly [number, number, number] }[] {
  const size = body.offsets[1] / 0.841;
  return [
    { bone: body.indexOf("Head"), end: [0, 0.17 * size, 0] as const },
    { bone: body.indexOf("RightFoot"), end: [0, -0.1 * size, 0.1575 * size] as const },
    { bone: body.indexOf("LeftFoot"), end: [0, -0.1 * size, 0.1575 * size] as const },
  ].filter(each => each.bone >= 0);
}

// A matrix that puts the shape at a point, along a vector, with a radius.
function placeStick(
  into: Float32Array, at: number, x: number, y: number, z: number, dx: number, dy: number, dz: number, radius: number,
): void {
  const length = Math.hypot(dx, dy, dz) || 1e-6;
  const ux = dx / length, uy = dy / length, uz = dz / length;

  // A direction across the stick: with the axis that is least along it.
  let sx: number, sy: number, sz: number;
  if (Math.abs(uy) < 0.9) {
    sx = -uz; sy = 0; sz = ux;
  } else {
    sx = 0; sy = uz; sz = -uy;
  }

  const scale = radius / Math.hypot(sx, sy, sz);
  sx *= scale; sy *= scale; sz *= scale;
  into[at] = sx; into[at + 1] = sy; into[at + 2] = sz; into[at + 3] = 0;
  into[at + 4] = dx; into[at + 5] = dy; into[at + 6] = dz; into[at + 7] = 0;
  into[at + 8] = sy * uz - sz * uy; into[at + 9] = sz * ux - sx * uz; into[at + 10] = sx * uy - sy * ux; into[at + 11] = 0;
  into[at + 12] = x; into[at + 13] = y; into[at + 14] = z; into[at + 15] = 1;
}
