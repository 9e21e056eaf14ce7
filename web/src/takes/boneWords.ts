import type { PerformerInfo } from "../live/messages";

const Trunk: readonly (readonly [name: string, words: string])[] = [
  ["Hips", "Hips"],
  ["Spine", "Lowest spine bone"],
  ["Spine1", "Second spine bone"],
  ["Spine2", "Third spine bone"],
  ["Spine3", "Fourth spine bone"],
  ["Neck1", "Upper neck"],
  ["Head", "Head"],
];

const Limbs: readonly (readonly [name: string, words: string])[] = [
  ["UpLeg", "thigh"],
  ["Leg", "shin"],
  ["Foot", "foot"],
  ["Shoulder", "collarbone"],
  ["Arm", "upper arm"],
  ["ForeArm", "forearm"],
  ["Hand", "hand"],
  ["HandThumb1", "thumb, metacarpal"],
  ["HandThumb2", "thumb, proximal"],
  ["HandThumb3", "thumb, distal"],
  ...[["Index", "index finger"], ["Middle", "middle finger"], ["Ring", "ring finger"], ["Pinky", "little finger"]].flatMap(([name, words]) => [
    [`InHand${name}`, `${words}, metacarpal`],
    [`Hand${name}1`, `${words}, proximal`],
    [`Hand${name}2`, `${words}, middle`],
    [`Hand${name}3`, `${words}, distal`],
  ] as const),
];

const Words: ReadonlyMap<string, string> = new Map([
  ...Trunk,
  ...["Left", "Right"].flatMap(side => Limbs.map(([name, words]) => [side + name, `${side} ${words}`] as const)),
]);

/** "RightUpLeg" as "Right thigh". The bone Neck is the whole neck in one variant of the skeleton. */
export function wordsOf(bone: string, variant: PerformerInfo["variant"]): string {
  if (bone === "Neck")
    return variant === "Neck1" ? "Lower neck" : "Neck";
  return Words.get(bone) ?? bone;
}
