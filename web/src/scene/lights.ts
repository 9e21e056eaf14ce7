import { DirectionalLight, Group, HemisphereLight } from "three";
import type { SceneColours } from "./colours";

const ShadowReach = 2.5;

// How far a surface is moved for the comparison with the shadows, in their pixels: less gives stripes on round surfaces.
const BiasInPixels = 3;

/** Light from the sky, and a sun whose shadows follow the performers. */
export class Lights {
  readonly group = new Group();
  private readonly _sky = new HemisphereLight();
  private readonly _sun = new DirectionalLight(0xfff6ea);
  private readonly _rim = new DirectionalLight(0xbfd4ff, 0.9);
  private _reach = 0;

  constructor() {
    this._sun.castShadow = true;
    this._sun.shadow.mapSize.set(2048, 2048);
    this._sun.shadow.bias = -0.0004;
    this._sun.shadow.radius = 3;
    this._sun.shadow.camera.near = 1;
    this._sun.shadow.camera.far = 40;
    this._rim.position.set(-4, 3, -5);
    this.group.add(this._sky, this._sun, this._sun.target, this._rim);
    this.cover(0, 0, ShadowReach);
  }

  /** Shadows cover a circle on the floor, in metres. */
  cover(x: number, z: number, radius: number): void {
    this._sun.position.set(x + 4, 10, z + 6);
    this._sun.target.position.set(x, 0, z);
    const reach = Math.max(ShadowReach, Math.ceil(2 * radius) / 2);
    if (reach === this._reach)
      return;

    this._reach = reach;
    const camera = this._sun.shadow.camera;
    camera.left = camera.bottom = -reach;
    camera.right = camera.top = reach;
    camera.updateProjectionMatrix();
    this._fitBias();
  }

  /** Pixels of a side of the shadows' picture; 0 for no shadows. */
  setDetail(pixels: number): void {
    this._sun.castShadow = pixels > 0;
    if (pixels === 0)
      return;

    this._sun.shadow.mapSize.set(pixels, pixels);
    this._sun.shadow.map?.dispose();
    this._sun.shadow.map = null;
    this._fitBias();
  }

  paint(colours: SceneColours): void {
    this._sky.color.setHex(colours.sky);
    this._sky.groundColor.setHex(colours.ground);
    this._sky.intensity = colours.skyStrength;
    this._sun.intensity = colours.sunStrength;
  }

  private _fitBias(): void {
    this._sun.shadow.normalBias = BiasInPixels * 2 * this._reach / this._sun.shadow.mapSize.x;
  }
}
