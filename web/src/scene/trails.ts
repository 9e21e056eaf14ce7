import {
  BufferAttribute, Color, DoubleSide, DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial, Vector2, type Vector3,
} from "three";
import type { Body } from "./body";

const Limbs = ["LeftHand", "RightHand", "LeftFoot", "RightFoot"];
const Seconds = 2.5;

// For each limb, pieces between two poses. At 120 poses a second, they last as long as the trail.
const PiecesPerLimb = 300;

// What is longer, in seconds, or faster, in metres per second, is a jump in time or place. The trail does not join its ends.
const LongestPause = 1;
const Fastest = 15;

const vertexShader = `
  attribute vec3 start;
  attribute vec3 end;
  attribute float born;
  uniform float now;
  uniform float seconds;
  uniform vec2 size;
  varying float strength;
  void main() {
    float age = now - born;
    strength = 1.0 - age / seconds;
    if (age < 0.0 || strength <= 0.0) {
      gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
      return;
    }
    vec4 a = projectionMatrix * viewMatrix * vec4(start, 1.0);
    vec4 b = projectionMatrix * viewMatrix * vec4(end, 1.0);
    vec2 along = (b.xy / b.w - a.xy / a.w) * size;
    float reach = length(along);
    along = reach > 0.0001 ? along / reach : vec2(1.0, 0.0);
    vec4 at = mix(a, b, position.y);
    vec2 shift = vec2(-along.y, along.x) * position.x + along * (position.y - 0.5) * 0.8;
    at.xy += shift * (0.8 + 2.2 * strength) / size * at.w;
    gl_Position = at;
  }`;

const fragmentShader = `
  uniform vec3 colour;
  varying float strength;
  void main() {
    gl_FragColor = vec4(colour, 0.85 * strength * strength);
    #include <colorspace_fragment>
  }`;

/** Where hands and feet were in the last seconds: ribbons that become thin and fade. */
export class Trails {
  readonly mesh: Mesh;
  private readonly _body: Body;
  private readonly _bones: readonly number[];
  private readonly _start: InstancedBufferAttribute;
  private readonly _end: InstancedBufferAttribute;
  private readonly _born: InstancedBufferAttribute;
  private readonly _material: ShaderMaterial;
  private readonly _last = new Float32Array(Limbs.length * 3);
  private _lastTime = NaN;
  private _firstTime = 0;
  private _next = 0;

  constructor(body: Body, colour: string, size: Vector2) {
    this._body = body;
    this._bones = Limbs.map(name => body.indexOf(name));
    const count = PiecesPerLimb * Limbs.length;
    const geometry = new InstancedBufferGeometry();
    geometry.instanceCount = count;
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, 0, 0, 1, 0, 0, 1, 1, 0, -1, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this._start = new InstancedBufferAttribute(new Float32Array(count * 3), 3).setUsage(DynamicDrawUsage);
    this._end = new InstancedBufferAttribute(new Float32Array(count * 3), 3).setUsage(DynamicDrawUsage);
    this._born = new InstancedBufferAttribute(new Float32Array(count).fill(-1e6), 1).setUsage(DynamicDrawUsage);
    geometry.setAttribute("start", this._start);
    geometry.setAttribute("end", this._end);
    geometry.setAttribute("born", this._born);
    this._material = new ShaderMaterial({
      vertexShader,
      fragmentShader,
      uniforms: { colour: { value: new Color(colour) }, now: { value: 0 }, seconds: { value: Seconds }, size: { value: size } },
      side: DoubleSide,
      transparent: true,
      depthWrite: false,
    });
    this.mesh = new Mesh(geometry, this._material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
  }

  /**
   * Adds the pose that the body shows. `time` in milliseconds; a time before the last one begins new trails. `offset` is the way from the stream's places to
   * those on the stage. The trails do not move with it: they stay where hands and feet were.
   */
  update(time: number, offset: Vector3): void {
    const pause = (time - this._lastTime) / 1000;
    if (!(pause >= 0 && pause < LongestPause)) {
      this._firstTime = time;
      (this._born.array as Float32Array).fill(-1e6);
      this._upload(0, PiecesPerLimb);
      this._remember(time, offset);
      return;
    }

    const now = (time - this._firstTime) / 1000;
    this._material.uniforms.now.value = now;
    if (pause === 0)
      return;

    for (let limb = 0; limb < this._bones.length; limb++)
      this._addPiece(limb, this._next * Limbs.length + limb, now, pause * Fastest, offset);
    this._upload(this._next, 1);
    this._next = (this._next + 1) % PiecesPerLimb;
    this._remember(time, offset);
  }

  dispose(): void {
    this.mesh.removeFromParent();
    this.mesh.geometry.dispose();
    this._material.dispose();
  }

  private _addPiece(limb: number, piece: number, now: number, longest: number, offset: Vector3): void {
    const positions = this._body.positions;
    const from = limb * 3, to = this._bones[limb] * 3, at = piece * 3;
    const start = this._start.array as Float32Array, end = this._end.array as Float32Array;
    let square = 0;
    for (let i = 0; i < 3; i++) {
      start[at + i] = this._last[from + i];
      end[at + i] = positions[to + i] + offset.getComponent(i);
      square += (end[at + i] - start[at + i]) ** 2;
    }

    this._born.array[piece] = square < longest * longest ? now : -1e6;
  }

  private _remember(time: number, offset: Vector3): void {
    this._lastTime = time;
    for (let limb = 0; limb < this._bones.length; limb++) {
      for (let i = 0; i < 3; i++)
        this._last[limb * 3 + i] = this._body.positions[this._bones[limb] * 3 + i] + offset.getComponent(i);
    }
  }

  // Only the new pieces go to the graphics card.
  private _upload(piece: number, count: number): void {
    for (const attribute of [this._start, this._end, this._born]) {
      if (count === PiecesPerLimb)
        attribute.clearUpdateRanges();
      attribute.addUpdateRange(piece * Limbs.length * attribute.itemSize, count * Limbs.length * attribute.itemSize);
      attribute.needsUpdate = true;
    }
  }
}
