import { Color, NeutralToneMapping, type Object3D, PCFShadowMap, PerspectiveCamera, Scene, type WebGLRenderer } from "three";
import { watchPixelRatio } from "../page/pixelRatio";
import { DarkScene, LightScene } from "./colours";
import { Floor } from "./floor";
import { createGraphics } from "./graphics";
import { Lights } from "./lights";

/** The scene with light and floor, and the canvas that shows it. Metres, Y up. */
export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(35, 1, 0.05, 200);
  readonly renderer: WebGLRenderer;
  readonly canvas: HTMLCanvasElement;
  /** True if the processor draws. */
  readonly isSoftware: boolean;
  readonly floor = new Floor();
  readonly lights = new Lights();
  private readonly _background = new Color();
  private readonly _place: HTMLElement;
  private readonly _changed: () => void;
  private _mostPixels = 2;
  /** The size of the canvas on the page. Reading it from the canvas could lay out the page. */
  width = 0;
  height = 0;

  constructor(place: HTMLElement, changed: () => void) {
    this._place = place;
    this._changed = changed;
    const { renderer, isSoftware } = createGraphics();
    this.renderer = renderer;
    this.canvas = renderer.domElement;
    this.isSoftware = isSoftware;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.toneMapping = NeutralToneMapping;
    this.scene.background = this._background;
    this.scene.add(this.floor.group, this.lights.group);
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "The performers. Drag to turn the view; the arrow keys turn it as well.");
    place.prepend(this.canvas);
    new ResizeObserver(() => this._fit()).observe(place);
    watchPixelRatio(() => this._fit());
    this.canvas.addEventListener("webglcontextrestored", changed);
  }

  draw(): void {
    this.renderer.render(this.scene, this.camera);
  }

  /** Compiles the materials of an object that is not in the scene yet. Waits for them where the browser tells when they are ready. */
  async prepare(object: Object3D): Promise<void> {
    if (this.renderer.extensions.has("KHR_parallel_shader_compile"))
      await this.renderer.compileAsync(object, this.camera, this.scene);
    else
      this.renderer.compile(object, this.camera, this.scene);
  }

  /** @param pixels The most pixels for a point of the page. @param shadows Pixels of the shadows' side; 0 for none. */
  setQuality(pixels: number, shadows: number): void {
    this._mostPixels = pixels;
    this.lights.setDetail(shadows);
    this.floor.hasShadows = shadows > 0;
    this._fit();
  }

  /** Shows the colours of the dark or the light theme. */
  paint(dark: boolean): void {
    const colours = dark ? DarkScene : LightScene;
    this._background.setHex(colours.background);
    this.floor.paint(colours);
    this.lights.paint(colours);
    this._changed();
  }

  private _fit(): void {
    const { clientWidth: width, clientHeight: height } = this._place;
    if (width === 0 || height === 0)
      return;

    this.width = width;
    this.height = height;
    this.renderer.setPixelRatio(Math.min(this._mostPixels, devicePixelRatio));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this._changed();
    this.draw();
  }
}
