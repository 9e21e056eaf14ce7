import { type Color, type Material, MeshLambertMaterial, MeshStandardMaterial } from "three";

/**
 * A material of something solid. A processor that draws needs a fraction of the time to compile the one without gloss.
 * @param isSoftware True if the processor draws.
 */
export function createSolid(color: Color, roughness: number, isSoftware: boolean): MeshLambertMaterial | MeshStandardMaterial {
  return isSoftware ? new MeshLambertMaterial({ color }) : new MeshStandardMaterial({ color, roughness });
}

/** The same without gloss, for a processor that draws. A material of another kind stays. */
export function withoutGloss(material: Material): Material {
  return material instanceof MeshStandardMaterial
    ? new MeshLambertMaterial({ color: material.color, map: material.map, vertexColors: material.vertexColors, side: material.side })
    : material;
}
