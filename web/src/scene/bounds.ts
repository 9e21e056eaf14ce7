import { type Mesh, SkinnedMesh } from "three";

/** Draws a mesh wherever its bones carry it. Its bounds are those of the rest pose, and it walks away from them. */
export function drawEverywhere(mesh: Mesh): void {
  mesh.frustumCulled = false;
  if (!(mesh instanceof SkinnedMesh))
    return;

  // three.js still sorts by the middle of the bounds. It would move every corner of the skin by its bones to find it, in the first picture.
  mesh.geometry.computeBoundingSphere();
  mesh.boundingSphere = mesh.geometry.boundingSphere;
}
