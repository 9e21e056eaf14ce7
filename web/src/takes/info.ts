import type { PerformerInfo } from "../live/messages";

/** Start and end of a stretch of time, in milliseconds. */
export type Stretch = readonly [number, number];

/** A performer of a take, as the server describes it. Times are milliseconds since the start of the take. */
export interface TakePerformerInfo extends PerformerInfo {
  readonly frames: number;
  readonly start: number;
  readonly end: number;
  /** Frames per second, or null. */
  readonly rate: number | null;
  readonly gaps: readonly Stretch[];
}

export interface TakeInfo {
  readonly id: string;
  readonly name: string;
  readonly kind: "bvh" | "nmrec" | "calc" | "raw";
  readonly duration: number;
  /** How much of the file the server has read, 0 to 1. */
  readonly progress: number;
  readonly performers: readonly TakePerformerInfo[];
  readonly problems: readonly string[];
}

export interface TakeContacts {
  readonly left: readonly Stretch[];
  readonly right: readonly Stretch[];
}

export interface CurveData {
  readonly unit: string;
  readonly times: readonly number[];
  readonly min: readonly (number | null)[];
  readonly max: readonly (number | null)[];
}

export const KindWords: Readonly<Record<TakeInfo["kind"], string>> = {
  bvh: "BVH",
  nmrec: "Recording",
  calc: "Calculation export",
  raw: "Raw stream",
};

/** Only what the stage needs: it makes a performer anew if this changes. */
export function toPerformer({ key, name, index, colour, variant, bones }: TakePerformerInfo): PerformerInfo {
  return { key, name, index, colour, variant, bones };
}

/** Whether a time is in one of the stretches, which are in order. Allocates nothing. */
export function isIn(stretches: readonly Stretch[], time: number): boolean {
  let low = 0;
  let high = stretches.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (stretches[middle][0] <= time)
      low = middle + 1;
    else
      high = middle;
  }

  return low > 0 && time <= stretches[low - 1][1];
}
