import { type BufferGeometry, type Mesh, SkinnedMesh, type Sphere } from "three";

/** Draws a mesh wherever its bones carry it. The bounds are those of the rest pose, and a performer walks away from them. */
export function drawEverywhere(mesh: Mesh): void {
  mesh.frustumCulled = false;
  if (!(mesh instanceof SkinnedMesh))
    return;

  // three.js still sorts by the middle of the bounds. In the first picture, it would move every corner of the skin by its bones to find the middle.
  mesh.boundingSphere = boundsOf(mesh.geometry);
}

/** The bounds of the rest pose. A loader may have read them from the file. */
export function boundsOf(geometry: BufferGeometry): Sphere {
  if (!geometry.boundingSphere)
    geometry.computeBoundingSphere();
  return geometry.boundingSphere!;
}
