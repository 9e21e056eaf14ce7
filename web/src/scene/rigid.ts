import { BufferGeometry, type Material, Mesh, type SkinnedMesh } from "three";
import { boundsOf } from "./bounds";
import { withoutGloss } from "./materials";

/**
 * Replaces a skinned mesh by one mesh for each bone. Every vertex must follow a single bone, as those of the jointed figure do. A processor that draws needs
 * a tenth of the time, because it does not blend the bones for each corner of each triangle.
 */
export function makeRigid(skinned: SkinnedMesh): void {
  const { geometry, skeleton, material } = skinned;
  const index = geometry.getIndex();
  const boneOf = geometry.getAttribute("skinIndex");
  if (!index)
    return;

  const corners = new Map<number, number[]>();
  for (let i = 0; i < index.count; i += 3) {
    const bone = boneOf.getX(index.getX(i));
    const list = corners.get(bone) ?? [];
    corners.set(bone, list);
    list.push(index.getX(i), index.getX(i + 1), index.getX(i + 2));
  }

  // The parts share all corners. Without bounds, three.js would measure all corners for each part.
  const bounds = boundsOf(geometry);
  const simple = withoutGloss(material as Material);
  for (const [bone, list] of corners) {
    const part = new BufferGeometry();
    part.setAttribute("position", geometry.getAttribute("position"));
    part.setAttribute("normal", geometry.getAttribute("normal"));
    part.setIndex(list);
    part.boundingSphere = bounds;
    const mesh = new Mesh(part, simple);
    mesh.matrixAutoUpdate = false;
    mesh.matrix.multiplyMatrices(skeleton.boneInverses[bone], skinned.bindMatrix);
    skeleton.bones[bone].add(mesh);
  }

  skinned.removeFromParent();
  skeleton.dispose();
}
