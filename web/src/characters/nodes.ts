import { Matrix4, Object3D, Quaternion, SkinnedMesh, Vector3 } from "three";

/** The most nodes that the server takes. */
export const MostNodes = 4096;

const Identity = 1e-4;

/** A node as the server wants it: relative to its parent, in glTF's axes. */
export interface NodeInfo {
  readonly name: string;
  readonly parent: number;
  readonly translation: readonly number[];
  readonly rotation: readonly number[];
  readonly scale: readonly number[];
}

/** Lists the joints of all skins with everything above them, parents first. Without a skin, all nodes. */
export function collectNodes(root: Object3D): Object3D[] {
  const joints = new Set<Object3D>();
  root.traverse(object => {
    if (object instanceof SkinnedMesh)
      object.skeleton.bones.forEach(bone => joints.add(bone));
  });
  const wanted = new Set<Object3D>([root]);
  for (const joint of joints) {
    for (let node: Object3D | null = joint; node && node !== root.parent; node = node.parent)
      wanted.add(node);
  }

  const nodes: Object3D[] = [];
  root.traverse(object => {
    if (joints.size === 0 || wanted.has(object))
      nodes.push(object);
  });
  return nodes;
}

/** Describes nodes for the server. Each parent is in the list, before its children. */
export function describeNodes(nodes: readonly Object3D[]): NodeInfo[] {
  const indices = new Map(nodes.map((node, index) => [node, index]));
  return nodes.map(node => ({
    name: nameOf(node),
    parent: node.parent ? indices.get(node.parent) ?? -1 : -1,
    translation: node.position.toArray(),
    rotation: node.quaternion.toArray(),
    scale: node.scale.toArray(),
  }));
}

/** The name of a node in its file. The loader takes some characters out of the name of the object. */
export function nameOf(node: Object3D): string {
  return typeof node.userData["name"] === "string" ? node.userData["name"] : node.name;
}

/**
 * Puts joints into the pose that the skin was bound in. Some exporters leave the pose of an animation's frame in the nodes. The topmost joints stay as they
 * are, because a skin does not say where the figure stands.
 */
export function restoreBindPose(root: Object3D): void {
  const done = new Set<Object3D>();
  const local = new Matrix4();
  const [position, rotation, scale] = [new Vector3(), new Quaternion(), new Vector3()];
  root.traverse(object => {
    if (!(object instanceof SkinnedMesh))
      return;

    const { bones, boneInverses } = object.skeleton;
    const indices = new Map(bones.map((bone, index) => [bone as Object3D, index]));
    bones.forEach((bone, index) => {
      const parent = bone.parent ? indices.get(bone.parent) : undefined;
      if (parent === undefined || done.has(bone) || boneInverses[index].determinant() === 0)
        return;

      done.add(bone);
      local.copy(boneInverses[index]).invert().premultiply(boneInverses[parent]);
      local.decompose(position, rotation, scale);
      if (isSound(local, position, rotation, scale) && rotation.angleTo(bone.quaternion) > 0.002)
        bone.quaternion.copy(rotation);
    });
  });
  root.updateMatrixWorld(true);
}

/** The height of the lowest vertex of the figure at rest, in the axes of the root's parent. Undefined without vertices. */
export function findLowest(root: Object3D): number | undefined {
  root.updateMatrixWorld(true);
  const hasSkin = isSkinned(root);
  const toWorld = new Matrix4();
  let lowest = Infinity;
  root.traverse(object => {
    const mesh = object as SkinnedMesh;
    if (!mesh.isMesh || hasSkin && !mesh.isSkinnedMesh)
      return;

    toWorld.copy(mesh.matrixWorld);
    if (mesh.isSkinnedMesh && mesh.skeleton.bones.length > 0)
      toWorld.copy(mesh.skeleton.bones[0].matrixWorld).multiply(mesh.skeleton.boneInverses[0]).multiply(mesh.bindMatrix);
    lowest = Math.min(lowest, lowestOf(mesh, toWorld.elements));
  });
  return Number.isFinite(lowest) ? lowest : undefined;
}

function isSkinned(root: Object3D): boolean {
  let found = false;
  root.traverse(object => {
    found ||= object instanceof SkinnedMesh;
  });
  return found;
}

function lowestOf(mesh: SkinnedMesh, e: readonly number[]): number {
  const points = mesh.geometry.getAttribute("position");
  let lowest = Infinity;
  for (let i = 0; i < (points?.count ?? 0); i++)
    lowest = Math.min(lowest, e[1] * points.getX(i) + e[5] * points.getY(i) + e[9] * points.getZ(i) + e[13]);
  return lowest;
}

// A sheared matrix has no rotation.
function isSound(matrix: Matrix4, position: Vector3, rotation: Quaternion, scale: Vector3): boolean {
  const again = new Matrix4().compose(position, rotation, scale);
  const size = Math.max(...matrix.elements.map(Math.abs));
  return Number.isFinite(size) && matrix.elements.every((value, i) => Math.abs(value - again.elements[i]) <= Identity * size);
}
