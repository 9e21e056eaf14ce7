import { Color, Group, Mesh, PlaneGeometry, ShaderMaterial, ShadowMaterial } from "three";
import type { SceneColours } from "./colours";

const Size = 60;

const vertexShader = `
  varying vec3 place;
  void main() {
    place = (modelMatrix * vec4(position, 1.0)).xyz;
    gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
  }`;

// Lines of one pixel at every distance. Lines closer than a few pixels fade, so that the horizon does not flicker.
const fragmentShader = `
  uniform vec3 colour;
  uniform float strength;
  uniform vec3 centre;
  varying vec3 place;

  float lines(vec2 at, float step, float width) {
    vec2 cell = at / step;
    vec2 size = fwidth(cell);
    vec2 near = abs(fract(cell - 0.5) - 0.5) / size;
    vec2 fade = clamp(0.4 / size - 1.0, 0.0, 1.0);
    vec2 line = clamp(width - near, 0.0, 1.0) * fade;
    return max(line.x, line.y);
  }

  void main() {
    vec2 at = place.xz;
    float grid = max(lines(at, 1.0, 1.0), 0.9 * lines(at, 5.0, 1.6));
    grid = max(grid, 0.32 * lines(at, 0.25, 0.9) * (1.0 - smoothstep(2.0, 4.5, distance(at, centre.xz))));
    vec2 fromOrigin = abs(at) / fwidth(at);
    float origin = clamp(2.0 - min(fromOrigin.x, fromOrigin.y), 0.0, 1.0);
    float fade = 1.0 - smoothstep(5.0, 22.0, distance(at, centre.xz));
    gl_FragColor = vec4(colour, max(grid * strength, origin * strength * 1.7) * fade);
    #include <colorspace_fragment>
  }`;

/** The floor at height 0: a grid of metres, and the shadows on it. */
export class Floor {
  readonly group = new Group();
  private readonly _grid: ShaderMaterial;
  private readonly _shadow = new ShadowMaterial({ transparent: true, depthWrite: false });
  private readonly _shadows: Mesh;

  constructor() {
    this._grid = new ShaderMaterial({
      vertexShader,
      fragmentShader,
      uniforms: { colour: { value: new Color() }, strength: { value: 0 }, centre: { value: this.group.position } },
      transparent: true,
      depthWrite: false,
    });
    const plane = new PlaneGeometry(Size, Size).rotateX(-Math.PI / 2);
    this._shadows = new Mesh(plane, this._shadow);
    this._shadows.receiveShadow = true;
    const grid = new Mesh(plane, this._grid);
    grid.position.y = 0.001;
    grid.renderOrder = 1;
    this.group.add(this._shadows, grid);
  }

  set hasShadows(value: boolean) {
    this._shadows.visible = value;
  }

  /** Keeps the middle of the floor near the performers. The lines stay where they are. */
  moveTo(x: number, z: number): void {
    this.group.position.set(x, 0, z);
  }

  paint(colours: SceneColours): void {
    (this._grid.uniforms.colour.value as Color).setHex(colours.grid);
    this._grid.uniforms.strength.value = colours.gridStrength;
    this._shadow.opacity = colours.shadow;
  }
}
