import { decodeRotation } from "../live/pose";
import { blendRotations } from "../takes/blend";

const HeaderSize = 28;
const Version = 1;
const Kind = 2;

/** One pose of a character, as values for the nodes of its file. Reused: decoding writes into the same arrays. */
export class CharacterPose {
  /** Milliseconds: Unix time of a live pose, time since the start of a take. */
  time = 0;
  /** Position of the hips' node relative to its parent. */
  readonly hips = new Float32Array(3);
  /** A rotation (x, y, z, w) for each bone, relative to the parent of its node. */
  readonly rotations: Float32Array;

  constructor(readonly boneCount: number) {
    this.rotations = new Float32Array(boneCount * 4);
  }

  /** Reads a pose of the server. Returns false for bytes that are not a pose with this number of bones, and then changes nothing. */
  decode(view: DataView): boolean {
    if (view.byteLength !== HeaderSize + this.boneCount * 6 || view.getUint8(0) !== Version || view.getUint8(1) !== Kind
      || view.getUint16(2, true) !== this.boneCount)
      return false;

    this.time = timeOf(view);
    for (let axis = 0; axis < 3; axis++)
      this.hips[axis] = view.getFloat32(16 + axis * 4, true);
    for (let bone = 0; bone < this.boneCount; bone++)
      decodeRotation(view, HeaderSize + bone * 6, this.rotations, bone * 4);

    return true;
  }

  /** Moves the pose towards another one: 0 changes nothing, 1 is the other pose. */
  blend(next: CharacterPose, part: number): void {
    this.time += (next.time - this.time) * part;
    for (let axis = 0; axis < 3; axis++)
      this.hips[axis] += (next.hips[axis] - this.hips[axis]) * part;
    blendRotations(this.rotations, next.rotations, this.boneCount, part);
  }
}

/** The time of a pose in milliseconds. */
export function timeOf(view: DataView): number {
  return (view.getUint32(8, true) + view.getInt32(12, true) * 4294967296) / 1000;
}
