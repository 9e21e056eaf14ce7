import { type Material, type Mesh, type Object3D, type SkinnedMesh, Texture } from "three";

/** Frees everything that an object and its descendants hold on the graphics card, and the decoded pictures. */
export function freeObject(root: Object3D): void {
  const materials = new Set<Material>();
  root.traverse(object => {
    const mesh = object as Mesh & Partial<Pick<SkinnedMesh, "skeleton">>;
    mesh.geometry?.dispose();
    mesh.skeleton?.dispose();
    for (const material of mesh.material ? [mesh.material].flat() : [])
      materials.add(material);
  });
  const textures = new Set<Texture>();
  for (const material of materials) {
    collectTextures(material, textures);
    material.dispose();
  }

  for (const texture of textures)
    freeTexture(texture);
}

// The materials of VRM keep their pictures in uniforms.
function collectTextures(material: Material, into: Set<Texture>): void {
  const uniforms = (material as { uniforms?: Record<string, { value: unknown }> }).uniforms ?? {};
  for (const value of [...Object.values(material), ...Object.values(uniforms).map(uniform => uniform?.value)]) {
    if (value instanceof Texture)
      into.add(value);
  }
}

function freeTexture(texture: Texture): void {
  texture.dispose();
  const image = texture.source.data as { close?: () => void } | null;
  image?.close?.();
}
