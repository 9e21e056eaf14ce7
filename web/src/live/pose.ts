/** Number of bones of the stream. */
export const BoneCount = 59;

const HeaderSize = 32;
const Size = HeaderSize + BoneCount * 6;
const Scale = 1 / (16383 * Math.SQRT2);

/** One avatar at one moment. Reused: decoding writes into the same arrays. */
export class Pose {
  /** The number of the avatar, -1 before the first pose. */
  avatar = -1;
  /** Milliseconds: Unix time of a live pose, time since the start of a take. */
  time = 0;
  /** Number of the frame on the server, or -1. */
  frame = -1;
  /** Position of the hips in the world, in metres. */
  readonly hips = new Float32Array(3);
  /** 59 rotations (x, y, z, w): the hips in the world, the others relative to the parent. */
  readonly rotations = new Float32Array(BoneCount * 4);

  copy(other: Pose): void {
    this.avatar = other.avatar;
    this.time = other.time;
    this.frame = other.frame;
    this.hips.set(other.hips);
    this.rotations.set(other.rotations);
  }
}

/** The avatar's number in a compact pose, or -1 for bytes that are not a pose. */
export function avatarOf(view: DataView): number {
  return isPose(view) ? view.getInt32(4, true) : -1;
}

/** Reads a compact pose (docs/reference/compact-pose.md). Returns false for bytes that are not a pose, and then changes nothing. */
export function decodePose(view: DataView, pose: Pose): boolean {
  if (!isPose(view))
    return false;

  pose.avatar = view.getInt32(4, true);
  pose.time = (view.getUint32(8, true) + view.getInt32(12, true) * 4294967296) / 1000;
  pose.frame = (view.getUint8(1) & 1) === 1 ? view.getUint32(16, true) : -1;
  for (let axis = 0; axis < 3; axis++)
    pose.hips[axis] = view.getFloat32(20 + axis * 4, true) / 100;
  for (let bone = 0; bone < BoneCount; bone++)
    decodeRotation(view, HeaderSize + bone * 6, pose.rotations, bone * 4);

  return true;
}

/** Reads a rotation of six bytes into four numbers (x, y, z, w). */
export function decodeRotation(view: DataView, offset: number, into: Float32Array, at: number): void {
  const first = view.getUint16(offset, true);
  const second = view.getUint16(offset + 2, true);
  const a = ((first & 0x7fff) - 16384) * Scale;
  const b = ((second & 0x7fff) - 16384) * Scale;
  const c = ((view.getUint16(offset + 4, true) & 0x7fff) - 16384) * Scale;
  const leftOut = first >> 15 | second >> 15 << 1;
  let next = at;
  if (leftOut === 0)
    next++;
  into[next++] = a;
  if (leftOut === 1)
    next++;
  into[next++] = b;
  if (leftOut === 2)
    next++;
  into[next] = c;
  into[at + leftOut] = Math.sqrt(Math.max(0, 1 - a * a - b * b - c * c));
}

function isPose(view: DataView): boolean {
  return view.byteLength >= Size && view.getUint8(0) === 1 && view.byteLength === Size + view.getUint8(2);
}
