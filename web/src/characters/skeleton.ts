import type { Object3D } from "three";
import type { LoadedCharacter } from "./load";
import { collectNodes, describeNodes, findLowest, MostNodes, type NodeInfo, restoreBindPose } from "./nodes";

/** What the server must know of a character to move it. */
export interface Skeleton {
  readonly objects: readonly Object3D[];
  readonly nodes: readonly NodeInfo[];
  readonly humanoid?: Readonly<Record<string, number>>;
  readonly lowest?: number;
}

/** Describes the skeleton at rest. The normalized bones of a VRM are not turned at rest, and move the bones of its file. */
export function describeSkeleton(character: LoadedCharacter): Skeleton {
  const { root, vrm, name } = character;
  if (!vrm)
    restoreBindPose(root);

  const lowest = findLowest(root);
  const objects = vrm ? normalizedNodes(root, vrm.humanoid.normalizedHumanBonesRoot) : collectNodes(root);
  if (objects.length > MostNodes)
    throw new Error(`${name} has ${objects.length} nodes. A character has at most ${MostNodes}.`);

  return { objects, nodes: describeNodes(objects), humanoid: vrm ? humanoidOf(vrm.humanoid.normalizedHumanBones, objects) : undefined, lowest };
}

function normalizedNodes(root: Object3D, bones: Object3D): Object3D[] {
  const nodes: Object3D[] = [root];
  bones.traverse(bone => nodes.push(bone));
  return nodes;
}

function humanoidOf(bones: Readonly<Record<string, { node: Object3D } | undefined>>, objects: readonly Object3D[]): Record<string, number> {
  const found: Record<string, number> = {};
  for (const [name, bone] of Object.entries(bones)) {
    const index = bone ? objects.indexOf(bone.node) : -1;
    if (index >= 0)
      found[name] = index;
  }

  return found;
}
