import { BufferAttribute, BufferGeometry, DynamicDrawUsage, LineBasicMaterial, LineSegments } from "three";
import type { Body } from "./body";

const Long = 0.09;
const Short = 0.022;
const Colours = [0.93, 0.29, 0.3, 0.35, 0.78, 0.35, 0.3, 0.53, 0.96];

/** The axes of every joint: X red, Y green, Z blue. */
export class JointAxes {
  readonly lines: LineSegments;
  private readonly _body: Body;
  private readonly _points: BufferAttribute;

  constructor(body: Body) {
    this._body = body;
    const count = body.names.length * 6;
    const colours = new Float32Array(count * 3);
    for (let point = 0; point < count; point++) {
      for (let i = 0; i < 3; i++)
        colours[point * 3 + i] = Colours[Math.floor(point % 6 / 2) * 3 + i];
    }

    this._points = new BufferAttribute(new Float32Array(count * 3), 3).setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this._points);
    geometry.setAttribute("color", new BufferAttribute(colours, 3));
    this.lines = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true, depthTest: false, toneMapped: false }));
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 3;
  }

  update(): void {
    const { positions, rotations, names } = this._body;
    const points = this._points.array as Float32Array;
    for (let bone = 0; bone < names.length; bone++) {
      const r = bone * 4, p = bone * 3;
      const x = rotations[r], y = rotations[r + 1], z = rotations[r + 2], w = rotations[r + 3];
      const length = bone >= 17 && bone <= 35 || bone >= 40 ? Short : Long;
      const at = bone * 18;
      line(points, at, positions, p, (1 - 2 * (y * y + z * z)) * length, 2 * (x * y + w * z) * length, 2 * (x * z - w * y) * length);
      line(points, at + 6, positions, p, 2 * (x * y - w * z) * length, (1 - 2 * (x * x + z * z)) * length, 2 * (y * z + w * x) * length);
      line(points, at + 12, positions, p, 2 * (x * z + w * y) * length, 2 * (y * z - w * x) * length, (1 - 2 * (x * x + y * y)) * length);
    }

    this._points.needsUpdate = true;
  }

  dispose(): void {
    this.lines.removeFromParent();
    this.lines.geometry.dispose();
    (this.lines.material as LineBasicMaterial).dispose();
  }
}

function line(into: Float32Array, at: number, from: Float32Array, p: number, x: number, y: number, z: number): void {
  for (let i = 0; i < 3; i++)
    into[at + i] = from[p + i];
  into[at + 3] = from[p] + x;
  into[at + 4] = from[p + 1] + y;
  into[at + 5] = from[p + 2] + z;
}
