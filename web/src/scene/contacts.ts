import { CircleGeometry, Color, Mesh, MeshBasicMaterial, RingGeometry, Vector3 } from "three";
import type { Body } from "./body";

const Height = 0.004;
const FadeIn = 60;
const FadeOut = 220;

const disc = new CircleGeometry(0.13, 40).rotateX(-Math.PI / 2);
const ring = new RingGeometry(0.122, 0.13, 48).rotateX(-Math.PI / 2);

/** A disc under each foot that stands on the floor. */
export class ContactMarks {
  readonly meshes: readonly Mesh[];
  private readonly _body: Body;
  private readonly _bones: readonly number[];
  private readonly _touches = [false, false];
  private readonly _strength = [0, 0];
  private readonly _toes = new Vector3();

  constructor(body: Body, colour: string) {
    this._body = body;
    this._bones = [body.indexOf("LeftFoot"), body.indexOf("RightFoot")];
    this.meshes = this._bones.map(() => {
      const material = new MeshBasicMaterial({ color: new Color(colour), transparent: true, depthWrite: false, toneMapped: false });
      const mesh = new Mesh(disc, material);
      mesh.add(new Mesh(ring, material.clone()));
      mesh.renderOrder = 2;
      mesh.visible = false;
      return mesh;
    });
  }

  set(left: boolean, right: boolean): void {
    this._touches[0] = left;
    this._touches[1] = right;
  }

  /** Moves and fades the discs. Returns whether what they show changes. */
  update(step: number, visible: boolean): boolean {
    let changed = false;
    for (let foot = 0; foot < 2; foot++) {
      const goal = this._touches[foot] ? 1 : 0;
      const strength = this._strength[foot];
      const next = goal > strength ? Math.min(goal, strength + step / FadeIn) : Math.max(goal, strength - step / FadeOut);
      changed ||= visible && next !== strength;
      this._strength[foot] = next;
      const mesh = this.meshes[foot];
      mesh.visible = visible && next > 0;
      (mesh.material as MeshBasicMaterial).opacity = 0.22 * next;
      ((mesh.children[0] as Mesh).material as MeshBasicMaterial).opacity = 0.8 * next;
      // A disc that fades stays where the foot was.
      if (goal === 1)
        this._place(mesh, this._bones[foot]);
    }

    return changed;
  }

  dispose(): void {
    for (const mesh of this.meshes) {
      mesh.removeFromParent();
      (mesh.material as MeshBasicMaterial).dispose();
      ((mesh.children[0] as Mesh).material as MeshBasicMaterial).dispose();
    }
  }

  // Between ankle and toes: the direction of the foot's Z axis along the floor.
  private _place(mesh: Mesh, bone: number): void {
    const { positions, rotations } = this._body;
    const r = bone * 4;
    const x = rotations[r], y = rotations[r + 1], z = rotations[r + 2], w = rotations[r + 3];
    this._toes.set(2 * (x * z + w * y), 0, 1 - 2 * (x * x + y * y)).normalize();
    mesh.position.set(positions[bone * 3] + 0.06 * this._toes.x, Height, positions[bone * 3 + 2] + 0.06 * this._toes.z);
  }
}
