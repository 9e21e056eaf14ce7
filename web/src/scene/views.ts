import { Box2, Vector2, Vector3 } from "three";
import type { Keys } from "../page/keys";
import type { SettingsStore } from "../page/settings";
import type { CameraRig } from "./cameraRig";
import type { Performer } from "./performer";
import type { Performers } from "./performers";
import type { Stage } from "./stage";

export type View = "orbit" | "front" | "side" | "top";

const Directions: Record<Exclude<View, "orbit">, readonly [yaw: number, pitch: number]> = {
  front: [0, 0],
  side: [Math.PI / 2, 0],
  top: [0, Math.PI / 2],
};

// What one performer needs around the middle, in metres: the name above the head, and hands to the sides.
const HalfHeight = 1.3;
const HalfWidth = 0.85;

// Half of the camera's angle, as a slope.
const Slope = Math.tan(17.5 * Math.PI / 180);

/** What the camera looks at, and from where. */
export class Views {
  private readonly _rig: CameraRig;
  private readonly _performers: Performers;
  private readonly _stage: Stage;
  private readonly _centre = new Vector3();
  private readonly _before = new Vector3();
  private readonly _area = new Box2();
  private readonly _point = new Vector2();
  private _spread = 0;
  private _places = 0;
  /** Places of performers and characters, and the spread, that the camera was last moved back for. */
  private _framed = 0;
  private _framedSpread = 0;
  private _following = false;
  private readonly _listeners: (() => void)[] = [];
  /** The performer that the camera follows, or null for all. */
  followed: string | null = null;
  view: View = "orbit";

  constructor(rig: CameraRig, performers: Performers, stage: Stage) {
    this._rig = rig;
    this._performers = performers;
    this._stage = stage;
  }

  /** Calls a function when the view or the followed performer changes. */
  onChange(listener: () => void): void {
    this._listeners.push(listener);
  }

  show(view: View): void {
    this.view = view;
    if (view === "orbit")
      this._rig.lookFrom(0.45, 0.16, false);
    else
      this._rig.lookFrom(...Directions[view], true);
    this._tell();
  }

  /** A hand has turned the camera: it is no longer exactly in front, beside or above. */
  turned(): void {
    if (this.view === "orbit")
      return;

    this.view = "orbit";
    this._rig.flat = false;
    this._tell();
  }

  /** Looks at a performer from now on, or at all. */
  follow(key: string | null): void {
    this.followed = key;
    this.frame();
    this._tell();
  }

  /** Brings the followed performers into the picture. */
  frame(): void {
    if (!this._measure())
      return;

    this._framed = this._places;
    this._framedSpread = this._spread;
    this._rig.target.copy(this._centre);
    this._rig.distance = this._distanceFor(this._spread);
    this._before.copy(this._centre);
  }

  /** Moves the camera along with the performers, and back while they walk apart. */
  update(follow: boolean): void {
    if (!this._measure()) {
      this._framed = 0;
      return;
    }

    if (this._places > this._framed) {
      const isFirst = this._framed === 0;
      this.frame();
      if (isFirst)
        this._rig.jump();
    } else if (follow && this._following) {
      this._rig.target.add(this._centre).sub(this._before);
      if (this._spread > this._framedSpread)
        this._rig.goBack(this._distanceFor(this._spread) - this._distanceFor(this._framedSpread));
    }

    this._framed = this._places;
    this._framedSpread = follow && this._following ? Math.max(this._framedSpread, this._spread) : this._spread;
    this._following = follow;
    this._before.copy(this._centre);
    this._stage.floor.moveTo(this._centre.x, this._centre.z);
    this._stage.lights.cover(this._centre.x, this._centre.z, this._spread + 2);
  }

  private _tell(): void {
    for (const listener of this._listeners)
      listener();
  }

  private _distanceFor(spread: number): number {
    return Math.max(HalfHeight, (HalfWidth + spread) / this._stage.camera.aspect) / Slope + 0.4 * spread;
  }

  // The centre of the followed performers and the characters beside them, at the height of the hips, and their distance from it. False if nobody is shown.
  private _measure(): boolean {
    this._area.makeEmpty();
    this._places = 0;
    let height = 0, count = 0;
    const one = this.followed === null ? undefined : this._performers.get(this.followed);
    if (one?.isOnStage) {
      this._include(one);
      height = this._heightOf(one);
      count = 1;
    } else {
      for (const performer of this._performers.all) {
        this._include(performer);
        if (!performer.isOnStage)
          continue;

        height += this._heightOf(performer);
        count++;
      }
    }

    if (count === 0)
      return false;

    const { min, max } = this._area;
    this._centre.set((min.x + max.x) / 2, height / count, (min.y + max.y) / 2);
    this._spread = Math.hypot(max.x - min.x, max.y - min.y) / 2;
    return true;
  }

  // A hidden performer keeps its places, so that hiding somebody does not frame the picture again.
  private _include(performer: Performer): void {
    if (!performer.hasPose)
      return;

    this._places++;
    if (!performer.hidden)
      this._area.expandByPoint(this._point.set(performer.x, performer.z));
    for (const { x, z } of performer.companions) {
      if (Number.isNaN(x))
        continue;

      this._places++;
      if (!performer.hidden)
        this._area.expandByPoint(this._point.set(x, z));
    }
  }

  // Steps and jumps must not shake the picture: the height of the standing performer.
  private _heightOf(performer: Performer): number {
    return performer.body.offsets[1] * 1.08;
  }
}

const KeyTurn = Math.PI / 24;

/** Keys that turn and move the camera. */
export function addCameraKeys(keys: Keys, rig: CameraRig, views: Views, settings: SettingsStore): void {
  const turn = (x: number, y: number) => () => {
    rig.turn((settings.now.mirror ? -x : x) * KeyTurn, y * KeyTurn);
    views.turned();
  };
  const camera = (key: string, label: string, does: string, run: () => void): void => {
    keys.add({ key, label, does, group: "Camera", repeats: true, run });
  };
  camera("ArrowLeft", "←", "Turn left", turn(-1, 0));
  camera("ArrowRight", "→", "Turn right", turn(1, 0));
  camera("ArrowUp", "↑", "Higher", turn(0, 1));
  camera("ArrowDown", "↓", "Lower", turn(0, -1));
  camera("+", "+", "Closer", () => rig.zoom(1 / 1.15));
  camera("-", "-", "Farther", () => rig.zoom(1.15));
  camera("h", "h", "Fit all performers", () => views.follow(null));
}
