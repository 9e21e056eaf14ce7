import { Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, WebGLRenderer } from "three";

/** The scene with light and floor, and the canvas that shows it. Metres, Y up. */
export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(35, 1, 0.05, 200);
  readonly renderer = new WebGLRenderer({ antialias: true, powerPreference: "high-performance" });
  readonly canvas = this.renderer.domElement;

  constructor(place: HTMLElement, changed: () => void) {
    place.append(this.canvas);
    this.scene.background = new Color(0x16181d);
    this.scene.add(new HemisphereLight(0xffffff, 0x444444, 1.2), new DirectionalLight(0xffffff, 2));
    this.camera.position.set(0, 1.5, 5);
    this.camera.lookAt(0, 1, 0);
    new ResizeObserver(() => {
      this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
      this.renderer.setSize(place.clientWidth, place.clientHeight);
      this.camera.aspect = place.clientWidth / Math.max(1, place.clientHeight);
      this.camera.updateProjectionMatrix();
      changed();
    }).observe(place);
  }

  draw(): void {
    this.renderer.render(this.scene, this.camera);
  }
}
