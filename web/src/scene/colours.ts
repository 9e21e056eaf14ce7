/** The colours of the scene that belong to a theme. */
export interface SceneColours {
  readonly background: number;
  readonly grid: number;
  readonly gridStrength: number;
  readonly sky: number;
  readonly ground: number;
  readonly skyStrength: number;
  readonly sunStrength: number;
  readonly shadow: number;
}

export const DarkScene: SceneColours = {
  background: 0x15171b,
  grid: 0xc3cad6,
  gridStrength: 0.2,
  sky: 0xdfe7f5,
  ground: 0x2a2d33,
  skyStrength: 1.5,
  sunStrength: 2.6,
  shadow: 0.42,
};

export const LightScene: SceneColours = {
  background: 0xeceef1,
  grid: 0x39414f,
  gridStrength: 0.24,
  sky: 0xffffff,
  ground: 0xb9bcc2,
  skyStrength: 1.9,
  sunStrength: 2.4,
  shadow: 0.2,
};
