import { Group, type Vector2, type Vector3 } from "three";
import type { PerformerInfo } from "../live/messages";
import { Pose } from "../live/pose";
import type { Settings } from "../page/settings";
import { JointAxes } from "./axes";
import { Body } from "./body";
import { ContactMarks } from "./contacts";
import type { Figure } from "./figure";
import { Sticks } from "./sticks";
import { Trails } from "./trails";

/** Metres between a performer and a character beside it. */
export const PlaceWidth = 1.1;

/** One performer on the stage. */
export class Performer {
  readonly info: PerformerInfo;
  readonly body: Body;
  /** The pose that the stage shows. */
  readonly pose = new Pose();
  /** Holds everything that the stage shows of the performer but characters. Its axes are the world's. */
  readonly group = new Group();
  /** False until the first pose. */
  hasPose = false;
  /** Poses since the performer came. */
  poses = 0;
  /** Set by a character that takes the place of the figure. Trails and names stay. */
  figureReplaced = false;
  /** Hidden by the list of performers. */
  hidden = false;
  /** Where the hips of the characters beside the performer are, in metres. NaN until a character has come. */
  companions: readonly Vector3[] = [];
  private readonly _sticks: Sticks;
  private readonly _axes: JointAxes;
  private readonly _trails: Trails;
  private readonly _contacts: ContactMarks;
  private _figure: Figure | null = null;
  private _hasChanged = false;

  constructor(info: PerformerInfo, pictureSize: Vector2, isSoftware: boolean) {
    this.info = info;
    this.body = new Body(info);
    this._sticks = new Sticks(this.body, info.colour, isSoftware);
    this._axes = new JointAxes(this.body);
    this._trails = new Trails(this.body, info.colour, pictureSize);
    this._contacts = new ContactMarks(this.body, info.colour);
    this.group.add(this._sticks.group, this._axes.lines, this._trails.mesh, ...this._contacts.meshes);
    this.group.visible = false;
  }

  /** Whether the stage shows the performer, or the character in its place. */
  get isOnStage(): boolean {
    return this.hasPose && !this.hidden;
  }

  /** Where the hips are on the stage, in metres. */
  get x(): number {
    return this.body.positions[0] + this.group.position.x;
  }

  get z(): number {
    return this.body.positions[2] + this.group.position.z;
  }

  get hasFigure(): boolean {
    return this._figure !== null;
  }

  /** Positions of the figure's nodes in the world. */
  figureJoints(): Record<string, [number, number, number]> {
    return this._figure?.joints(this.body.names) ?? {};
  }

  /** Replaces the sticks, unless they are chosen. */
  setFigure(figure: Figure): void {
    this._figure?.dispose();
    this._figure = figure;
    this.group.add(figure.root);
    this._hasChanged = true;
  }

  /** Shows a pose from now on. Copies it. */
  show(pose: Pose): void {
    this.pose.copy(pose);
    this.body.show(pose);
    this.hasPose = true;
    this.poses++;
    this._hasChanged = true;
  }

  /** Moves the group on the floor: marks, trails and the name go with the character in the performer's place. */
  standAt(x: number, z: number): void {
    const { positions } = this.body;
    this._moveTo(x - positions[0], z - positions[2]);
  }

  /** Without a character in its place, the performer stands where the stream says. */
  standAlone(): void {
    this._moveTo(0, 0);
  }

  setContacts(left: boolean, right: boolean): void {
    this._contacts.set(left, right);
  }

  /** Moves what is visible to the newest pose. Returns whether the picture changes. */
  update(settings: Settings, step: number): boolean {
    const faded = this._contacts.update(step, settings.contacts);
    if (!this._hasChanged)
      return faded && this.group.visible;

    this._hasChanged = false;
    this.group.visible = this.hasPose && !this.hidden;
    const withFigure = settings.look === "figure" && this._figure !== null;
    this._sticks.group.visible = !withFigure && !this.figureReplaced;
    this._axes.lines.visible = settings.axes;
    this._trails.mesh.visible = settings.trails;
    if (this._figure)
      this._figure.root.visible = withFigure && !this.figureReplaced;
    if (!this.group.visible)
      return true;

    if (this._figure?.root.visible)
      this._figure.show(this.pose);
    if (this._sticks.group.visible)
      this._sticks.update();
    if (settings.axes)
      this._axes.update();
    if (settings.trails)
      this._trails.update(this.pose.time, this.group.position);
    return true;
  }

  /** The settings or what replaces the figure have changed. */
  refresh(): void {
    this._hasChanged = true;
  }

  // Only what changes is drawn.
  private _moveTo(x: number, z: number): void {
    const { position } = this.group;
    if (position.x === x && position.z === z)
      return;

    position.set(x, 0, z);
    this._hasChanged = true;
  }

  dispose(): void {
    this.group.removeFromParent();
    this._figure?.dispose();
    this._sticks.dispose();
    this._axes.dispose();
    this._trails.dispose();
    this._contacts.dispose();
  }
}
