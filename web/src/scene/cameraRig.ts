import { MathUtils, type PerspectiveCamera, Vector3 } from "three";

const PerspectiveAngle = 35;

// Views from the front, the side and above show true proportions: nearly parallel rays, from far away.
const FlatAngle = 3;

const HighestPitch = Math.PI / 2 - 0.001;
const LowestPitch = -0.2;
const Nearest = 0.4;
const Farthest = 60;

// Time in which the camera covers about two thirds of its way, in milliseconds.
const Ease = 90;

/** A camera that looks at a point from an angle and a distance, and moves there smoothly. Angles in radians, lengths in metres. */
export class CameraRig {
  /** What the camera looks at. */
  readonly target = new Vector3(0, 0.95, 0);
  /** Where the camera is around the target: 0 is in front, +Z, and a quarter turn is at +X. */
  yaw = 0.45;
  /** Height of the camera as an angle. */
  pitch = 0.16;
  /** Distance at which a perspective camera would see as much. */
  distance = 4.6;
  /** Whether rays are nearly parallel. */
  flat = false;
  private readonly _camera: PerspectiveCamera;
  private readonly _at = new Vector3();
  private readonly _now = { yaw: 0.45, pitch: 0.16, distance: 4.6, angle: PerspectiveAngle };
  private _settled = false;

  constructor(camera: PerspectiveCamera) {
    this._camera = camera;
    this._at.copy(this.target);
  }

  /** The direction of the camera at this moment, as an angle around the vertical. */
  get shownYaw(): number {
    return this._now.yaw;
  }

  turn(yaw: number, pitch: number): void {
    this.yaw += yaw;
    this.pitch = MathUtils.clamp(this.pitch + pitch, LowestPitch, HighestPitch);
    this._settled = false;
  }

  /** Comes closer with a factor below 1. */
  zoom(factor: number): void {
    this.distance = MathUtils.clamp(this.distance * factor, Nearest, Farthest);
    this._settled = false;
  }

  /** Goes back by some metres, at most as far as a hand can. */
  goBack(way: number): void {
    this.distance = Math.max(this.distance, Math.min(Farthest, this.distance + way));
    this._settled = false;
  }

  /** Moves the target in the plane of the picture, in parts of the picture's height. */
  pan(right: number, up: number): void {
    const height = 2 * this.distance * Math.tan(MathUtils.degToRad(PerspectiveAngle / 2));
    const { yaw, pitch } = this._now;
    const x = right * height, y = up * height;
    this.target.x += Math.cos(yaw) * x - Math.sin(yaw) * Math.sin(pitch) * y;
    this.target.z += -Math.sin(yaw) * x - Math.cos(yaw) * Math.sin(pitch) * y;
    this.target.y = Math.max(0, this.target.y + Math.cos(pitch) * y);
    this._settled = false;
  }

  /** Looks from a direction, on the shorter way round. */
  lookFrom(yaw: number, pitch: number, flat: boolean): void {
    // The same angle as now, less than half a turn from the new one.
    this._now.yaw = yaw - MathUtils.euclideanModulo(yaw - this._now.yaw + Math.PI, 2 * Math.PI) + Math.PI;
    this.yaw = yaw;
    this.pitch = pitch;
    this.flat = flat;
    this._settled = false;
  }

  /** Goes to its place without a way. */
  jump(): void {
    this._at.copy(this.target);
    this._now.yaw = this.yaw;
    this._now.pitch = this.pitch;
    this._now.distance = this.distance;
    this._now.angle = this.flat ? FlatAngle : PerspectiveAngle;
    this._place();
  }

  /** Moves the camera for a step of milliseconds. Returns whether the picture changes. */
  update(step: number): boolean {
    const part = 1 - Math.exp(-step / Ease);
    const now = this._now;
    const angle = this.flat ? FlatAngle : PerspectiveAngle;
    const moved = this._at.distanceToSquared(this.target) > 1e-8 || Math.abs(this.yaw - now.yaw) > 1e-4
      || Math.abs(this.pitch - now.pitch) > 1e-4 || Math.abs(this.distance - now.distance) > 1e-4 || Math.abs(angle - now.angle) > 1e-3;
    if (!moved && this._settled)
      return false;

    this._settled = !moved;
    this._at.lerp(this.target, part);
    now.yaw += (this.yaw - now.yaw) * part;
    now.pitch += (this.pitch - now.pitch) * part;
    now.distance += (this.distance - now.distance) * part;
    now.angle += (angle - now.angle) * part;
    this._place();
    return true;
  }

  private _place(): void {
    const { yaw, pitch, distance, angle } = this._now;
    const camera = this._camera;
    const away = distance * Math.tan(MathUtils.degToRad(PerspectiveAngle / 2)) / Math.tan(MathUtils.degToRad(angle / 2));
    const level = Math.cos(pitch) * away;
    camera.position.set(this._at.x + Math.sin(yaw) * level, this._at.y + Math.sin(pitch) * away, this._at.z + Math.cos(yaw) * level);
    camera.rotation.set(-pitch, yaw, 0, "YXZ");
    camera.fov = angle;
    camera.near = Math.max(0.05, away - 30);
    camera.far = away + 60;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }
}
