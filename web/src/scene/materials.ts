import { type Color, type Material, MeshLambertMaterial, MeshStandardMaterial } from "three";

/**
 * A material of something solid, with gloss unless the processor draws. A processor compiles a material without gloss in a fraction of the time.
 * @param isSoftware True if the processor draws.
 */
export function createSolid(color: Color, roughness: number, isSoftware: boolean): MeshLambertMaterial | MeshStandardMaterial {
  return isSoftware ? new MeshLambertMaterial({ color }) : new MeshStandardMaterial({ color, roughness });
}

/** The material of the library's figure without gloss, for a processor that draws. A material of another kind stays. */
export function withoutGloss(material: Material): Material {
  return material instanceof MeshStandardMaterial ? new MeshLambertMaterial({ color: material.color, side: material.side }) : material;
}
