import { Group, type Object3D, Vector3 } from "three";
import { freeObject } from "./dispose";
import { PlaceWidth } from "../scene/performer";
import type { LoadedCharacter } from "./load";
import { CharacterPose } from "./pose";
import type { Skeleton } from "./skeleton";

/** How the server numbers the bones of a character. */
export interface CharacterBones {
  readonly id: number;
  readonly bones: readonly { readonly node: number; readonly bone: string; readonly humanoid: string | null }[];
  readonly hipsNode: number;
  readonly problems: readonly string[];
}

/** Springs become unstable in longer steps, in milliseconds. */
const LongestStep = 50;

/** Hair and clothes swing on for a while after the last pose, in milliseconds. */
const SwingFor = 2000;

/** A pose farther from the one before is another moment: metres of the hips, and milliseconds. */
const LongestMove = 0.5;
const LongestPause = 500;

/** Poses of one frame have the same time, in milliseconds. */
const SameTime = 0.5;

/** Hips that move faster have jumped, in metres per second. Nobody notices a jump over a shorter way, in metres. */
const Fastest = 15;
const ShortestJump = 0.1;

/** Poses of two sockets may never be of the same frame, on a slow network. After so many pictures, near ones will do. */
const MostMisses = 20;

type Point = [number, number, number];

/** A character on the stage. Allocates nothing per pose. */
export class Character {
  readonly name: string;
  readonly skeleton: Skeleton;
  /** Holds the character. Its axes are the world's. */
  readonly group = new Group();
  /** Key of the performer that it follows. */
  performer = "";
  /** Key of the performer that was chosen for it. It follows this one whenever it is there. */
  chosen = "";
  /** Whether it stands beside its performer, and does not replace the figure. */
  isBeside = false;
  /** Whether feet that touch the ground stay in their place. */
  plantsFeet = true;
  /** Where the hips are on the stage, in metres. NaN until the character has come to its performer. */
  readonly hipsOnStage = new Vector3(NaN, NaN, NaN);
  private readonly _loaded: LoadedCharacter;
  private readonly _point = new Vector3();
  private _bones: CharacterBones | null = null;
  private _objects: readonly Object3D[] = [];
  private _hips: Object3D | null = null;
  private _pose = new CharacterPose(0);
  private _next = new CharacterPose(0);
  private _place = 0;
  /** Whether it stands where its performer stood, or has walked on from there. */
  private _hasCome = false;
  private _hipsTime = 0;
  private _misses = 0;
  private _since = Infinity;
  private _hasPose = false;
  private _hasSwung = false;
  private _isHidden = false;

  constructor(loaded: LoadedCharacter, skeleton: Skeleton) {
    this.name = loaded.name;
    this.skeleton = skeleton;
    this._loaded = loaded;
    this.group.add(loaded.root);
    this.group.visible = false;
  }

  get bones(): CharacterBones | null {
    return this._bones;
  }

  /** Whether a pose has arrived, and the performer is not hidden. */
  get isShown(): boolean {
    return this.group.visible;
  }

  /** Hides the character together with its performer. */
  set isHidden(value: boolean) {
    this._isHidden = value;
    this._hasSwung &&= !value;
    this.group.visible = this._hasPose && !value;
  }

  /** Number of places beside the performer, 0 for the performer's own place. */
  set place(value: number) {
    if (value === this._place)
      return;

    this._place = value;
    this._hasCome = false;
    this._hasSwung = false;
  }

  get place(): number {
    return this._place;
  }

  /** Takes over how the server numbers the bones. */
  bind(bones: CharacterBones): void {
    this._bones = bones;
    this._objects = bones.bones.map(bone => this.skeleton.objects[bone.node]);
    this._hips = this.skeleton.objects[bones.hipsNode];
    this._pose = new CharacterPose(bones.bones.length);
    this._next = new CharacterPose(bones.bones.length);
  }

  /** Shows a pose of the server, or one on the way to the next. Returns false for bytes that are not one of this character. */
  show(view: DataView, next: DataView | null = null, part = 0): boolean {
    const before = this._pose.time;
    if (!this._hips || !this._pose.decode(view))
      return false;

    if (next && part > 0 && this._next.decode(next))
      this._pose.blend(this._next, part);
    const { rotations, hips } = this._pose;
    for (let i = 0; i < this._objects.length; i++)
      this._objects[i].quaternion.set(rotations[i * 4], rotations[i * 4 + 1], rotations[i * 4 + 2], rotations[i * 4 + 3]);
    const { position } = this._hips;
    const move = Math.hypot(hips[0] - position.x, hips[1] - position.y, hips[2] - position.z);
    this._hasSwung &&= move < LongestMove && Math.abs(this._pose.time - before) < LongestPause;
    position.set(hips[0], hips[1], hips[2]);
    this._hasPose = true;
    this.group.visible = !this._isHidden;
    this._since = 0;
    return true;
  }

  /**
   * Tells where the performer stands and the time of its pose. A character that has just appeared, or jumped, comes there. From then on it walks with the
   * stride of its own legs. Returns whether its pose is of the same moment.
   */
  accompany(x: number, z: number, time: number): boolean {
    if (!this._hips || !this._hasPose)
      return false;

    const isSame = Math.abs(time - this._pose.time) < SameTime;
    this._misses = isSame ? 0 : this._misses + 1;
    const fits = isSame || this._misses > MostMisses;
    const hips = this._hips.getWorldPosition(this._point);
    this._hasCome &&= !this._hasJumpedTo(hips);
    if (!this._hasCome) {
      const toX = x + this._place * PlaceWidth - hips.x, toZ = z - hips.z;
      this.group.position.x += toX;
      this.group.position.z += toZ;
      hips.x += toX;
      hips.z += toZ;
      this._hasCome = fits;
    }

    this.hipsOnStage.copy(hips);
    this._hipsTime = this._pose.time;
    return fits;
  }

  /** Moves what follows the bones. Returns whether the picture changes. */
  update(step: number): boolean {
    if (!this.group.visible || this._since > SwingFor)
      return false;

    const { vrm } = this._loaded;
    const isNew = this._since === 0;
    this._since += Math.max(1, step);
    if (!vrm)
      return isNew;

    // Without this, hair and clothes fly from the rest pose to the first pose, and from one moment to another.
    if (!this._hasSwung) {
      vrm.update(0);
      vrm.springBoneManager?.reset();
    }

    this._hasSwung = true;
    vrm.update(Math.min(step, LongestStep) / 1000);
    return true;
  }

  hide(): void {
    this.group.visible = false;
    this._hasPose = false;
    this._hasSwung = false;
    this._hasCome = false;
    this.hipsOnStage.set(NaN, NaN, NaN);
  }

  /** Positions of the bones in the world, by the names of the stream's bones. */
  joints(): Record<string, Point> {
    const found: Record<string, Point> = {};
    const { vrm } = this._loaded;
    for (const { node, bone, humanoid } of this._bones?.bones ?? []) {
      const raw = humanoid === null ? null : vrm?.humanoid.getRawBoneNode(humanoid as "hips");
      found[bone] = (raw ?? this.skeleton.objects[node]).getWorldPosition(this._point).toArray();
    }

    return found;
  }

  private _hasJumpedTo(hips: Vector3): boolean {
    const pause = this._pose.time - this._hipsTime;
    return pause < 0 || pause > LongestPause || hips.distanceTo(this.hipsOnStage) > ShortestJump + Fastest * pause / 1000;
  }

  dispose(): void {
    this.group.removeFromParent();
    freeObject(this.group);
  }
}
