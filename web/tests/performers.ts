import type { PerformerInfo } from "../src/live/messages";
import { BoneCount } from "../src/live/pose";

// Parents in the order of the stream, in the variant Neck1 (docs/reference/protocol.md).
const Parents = [
  -1, 0, 1, 2, 0, 4, 5, 0, 7, 8, 9, 10, 11,
  9, 13, 14, 15, 16, 17, 18, 16, 20, 21, 22, 16, 24, 25, 26, 16, 28, 29, 30, 16, 32, 33, 34,
  9, 36, 37, 38, 39, 40, 41, 39, 43, 44, 45, 39, 47, 48, 49, 39, 51, 52, 53, 39, 55, 56, 57,
];

/** A performer whose bones are all 10 cm long, each in a direction of its own. */
export function performer(key = "0-0"): PerformerInfo {
  return {
    key,
    name: `Performer ${key}`,
    index: 0,
    colour: "#4f8fdc",
    variant: "Neck1",
    bones: Parents.slice(0, BoneCount).map((parent, i) => ({
      name: `Bone${i}`,
      parent: parent < 0 ? null : `Bone${parent}`,
      offset: [0.1 * Math.sin(i), 0.1 * Math.cos(i), 0] as const,
    })),
  };
}
