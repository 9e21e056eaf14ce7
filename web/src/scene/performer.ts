import { Group } from "three";
import type { PerformerInfo } from "../live/messages";
import { Pose } from "../live/pose";
import { Body } from "./body";

/** One performer on the stage. */
export class Performer {
  readonly info: PerformerInfo;
  readonly body: Body;
  /** The pose that the stage shows. */
  readonly pose = new Pose();
  /** Holds everything that the stage shows of the performer. Its axes are the world's. */
  readonly group = new Group();
  /** False until the first pose. */
  hasPose = false;
  /** Set by a character that takes the place of the figure. Sticks, trails and names stay. */
  figureReplaced = false;

  constructor(info: PerformerInfo) {
    this.info = info;
    this.body = new Body(info);
  }

  /** Shows a pose from now on. Copies it. */
  show(pose: Pose): void {
    this.pose.copy(pose);
    this.hasPose = true;
    this.body.show(pose);
  }

  dispose(): void {
    this.group.removeFromParent();
  }
}
