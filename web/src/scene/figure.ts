import { Mesh, type MeshStandardMaterial, type Object3D, SkinnedMesh, Vector3 } from "three";
import type { Body } from "./body";
import { drawEverywhere } from "./bounds";
import type { Pose } from "../live/pose";
import { makeRigid } from "./rigid";

/** The skinned figure of a performer. Its nodes have the names of the stream's bones. */
export class Figure {
  readonly root: Object3D;
  private readonly _point = new Vector3();
  private readonly _bones: readonly (Object3D | undefined)[];

  private constructor(root: Object3D, body: Body) {
    this.root = root;
    const byName = new Map<string, Object3D>();
    root.traverse(node => byName.set(node.userData.name as string | undefined ?? node.name, node));
    this._bones = body.names.map(name => byName.get(name));
    // Otherwise three.js computes the Euler angles of each new rotation, which nobody reads.
    for (const bone of this._bones)
      bone?.quaternion._onChange(() => {});
    root.traverse(node => {
      if (!(node instanceof Mesh))
        return;

      node.castShadow = true;
      node.receiveShadow = true;
      drawEverywhere(node);
    });
  }

  /** @param isRigid Draws a mesh for each bone, which suits a processor, instead of a skin, which suits a graphics card. */
  static async load(file: Promise<ArrayBuffer>, body: Body, isRigid = false): Promise<Figure> {
    const [{ GLTFLoader }, bytes] = await Promise.all([import("three/addons/loaders/GLTFLoader.js"), file]);
    const { scene } = await new GLTFLoader().parseAsync(bytes, "");
    if (isRigid) {
      const skins: SkinnedMesh[] = [];
      scene.traverse(node => {
        if (node instanceof SkinnedMesh)
          skins.push(node);
      });
      skins.forEach(makeRigid);
    }

    return new Figure(scene, body);
  }

  show(pose: Pose): void {
    const rotations = pose.rotations;
    for (let i = 0; i < this._bones.length; i++)
      this._bones[i]?.quaternion.set(rotations[i * 4], rotations[i * 4 + 1], rotations[i * 4 + 2], rotations[i * 4 + 3]);
    this._bones[0]?.position.set(pose.hips[0], pose.hips[1], pose.hips[2]);
  }

  dispose(): void {
    this.root.removeFromParent();
    this.root.traverse(node => {
      const mesh = node as SkinnedMesh;
      mesh.geometry?.dispose();
      mesh.skeleton?.dispose();
      const materials = mesh.material ?? [];
      for (const material of Array.isArray(materials) ? materials : [materials])
        (material as MeshStandardMaterial).dispose();
    });
  }

  /** Positions of the bones' nodes in the world, as the last picture had them. */
  joints(names: readonly string[]): Record<string, [number, number, number]> {
    const found: Record<string, [number, number, number]> = {};
    this._bones.forEach((bone, i) => {
      if (bone)
        found[names[i]] = this._point.setFromMatrixPosition(bone.matrixWorld).toArray();
    });
    return found;
  }
}
