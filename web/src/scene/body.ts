import type { PerformerInfo } from "../live/messages";
import { BoneCount, type Pose } from "../live/pose";

/** A performer's skeleton and where its joints are in the world. Allocates nothing per pose. */
export class Body {
  readonly names: readonly string[];
  readonly parents: Int8Array;
  /** Positions relative to the parent in the rest pose, in metres. */
  readonly offsets: Float32Array;
  /** 59 positions in the world, in metres. */
  readonly positions = new Float32Array(BoneCount * 3);
  /** 59 rotations in the world (x, y, z, w). */
  readonly rotations = new Float32Array(BoneCount * 4);
  private readonly _indices: ReadonlyMap<string, number>;

  constructor(info: PerformerInfo) {
    this.names = info.bones.map(bone => bone.name);
    this._indices = new Map(this.names.map((name, index) => [name, index]));
    this.parents = Int8Array.from(info.bones, bone => bone.parent === null ? -1 : this.indexOf(bone.parent));
    this.offsets = Float32Array.from(info.bones.flatMap(bone => [...bone.offset]));
  }

  /** The index of a bone, or -1. */
  indexOf(name: string): number {
    return this._indices.get(name) ?? -1;
  }

  /** Forward kinematics: computes all joints of a pose. Parents come before their children. */
  show(pose: Pose): void {
    this.positions.set(pose.hips);
    for (let i = 0; i < 4; i++)
      this.rotations[i] = pose.rotations[i];
    for (let bone = 1; bone < this.parents.length; bone++)
      this._place(bone, this.parents[bone], pose.rotations);
  }

  private _place(bone: number, parent: number, local: Float32Array): void {
    const r = this.rotations;
    const p = parent * 4;
    const x = r[p], y = r[p + 1], z = r[p + 2], w = r[p + 3];

    // v + 2w(q × v) + 2q × (q × v)
    const o = bone * 3;
    const vx = this.offsets[o], vy = this.offsets[o + 1], vz = this.offsets[o + 2];
    const tx = 2 * (y * vz - z * vy), ty = 2 * (z * vx - x * vz), tz = 2 * (x * vy - y * vx);
    const at = parent * 3;
    this.positions[o] = this.positions[at] + vx + w * tx + y * tz - z * ty;
    this.positions[o + 1] = this.positions[at + 1] + vy + w * ty + z * tx - x * tz;
    this.positions[o + 2] = this.positions[at + 2] + vz + w * tz + x * ty - y * tx;

    const b = bone * 4;
    const lx = local[b], ly = local[b + 1], lz = local[b + 2], lw = local[b + 3];
    r[b] = w * lx + x * lw + y * lz - z * ly;
    r[b + 1] = w * ly - x * lz + y * lw + z * lx;
    r[b + 2] = w * lz + x * ly - y * lx + z * lw;
    r[b + 3] = w * lw - x * lx - y * ly - z * lz;
  }
}
