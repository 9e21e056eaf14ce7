import { BoneCount, type Pose } from "../live/pose";

/** Moves a pose towards another one: 0 changes nothing, 1 is the other pose. Rotations take the shorter way. Allocates nothing. */
export function blend(pose: Pose, next: Pose, part: number): void {
  pose.time += (next.time - pose.time) * part;
  for (let axis = 0; axis < 3; axis++)
    pose.hips[axis] += (next.hips[axis] - pose.hips[axis]) * part;
  blendRotations(pose.rotations, next.rotations, BoneCount, part);
}

/** Moves rotations (x, y, z, w) towards others. Between two frames of a take, straight lines differ from arcs by less than a screen shows. */
export function blendRotations(from: Float32Array, to: Float32Array, count: number, part: number): void {
  for (let i = 0; i < count * 4; i += 4) {
    const dot = from[i] * to[i] + from[i + 1] * to[i + 1] + from[i + 2] * to[i + 2] + from[i + 3] * to[i + 3];
    const step = dot < 0 ? -part : part;
    const rest = 1 - part;
    const x = from[i] * rest + to[i] * step;
    const y = from[i + 1] * rest + to[i + 1] * step;
    const z = from[i + 2] * rest + to[i + 2] * step;
    const w = from[i + 3] * rest + to[i + 3] * step;
    const scale = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
    from[i] = x * scale;
    from[i + 1] = y * scale;
    from[i + 2] = z * scale;
    from[i + 3] = w * scale;
  }
}
