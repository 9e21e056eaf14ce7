import type { Connection } from "../live/connection";
import type { LiveFeed } from "../live/feed";
import type { Performers } from "../scene/performers";
import type { Stage } from "../scene/stage";
import type { TakeInfo } from "../takes/info";
import type { Api } from "./api";
import type { Drops } from "./drops";
import type { Keys } from "./keys";
import type { Loop } from "./loop";
import type { Notices } from "./notices";
import type { SettingsStore } from "./settings";
import type { Slots } from "./slots";

/** What the parts of the page know of each other. */
export interface Page {
  readonly api: Api;
  readonly loop: Loop;
  /** The three.js scene. Objects that a part adds must be removed and disposed by it. */
  readonly stage: Stage;
  /** Who stands on the stage, live or from a take. */
  readonly performers: Performers;
  /** The messages of the server. */
  readonly connection: Connection;
  /** The live motion. A take pauses it. */
  readonly feed: LiveFeed;
  readonly settings: SettingsStore;
  readonly notices: Notices;
  readonly keys: Keys;
  readonly drops: Drops;
  /** Places of the document for the parts. */
  readonly slots: Slots;
}

/** What the folder takes gives to the page. */
export interface Takes {
  /** The take that is shown, or null for live motion. */
  readonly current: string | null;
  /** What the server knows of this take now. */
  readonly info: TakeInfo | null;
  /** Shows a take of the server instead of the live motion. */
  open(id: string): Promise<void>;
  /** Returns to the live motion. */
  close(): void;
  /** Calls a function when another take is shown, or more is known of it. */
  onChange(listener: () => void): void;
}

/** What the folder characters gives to the page. */
export interface Characters {
  /** Positions of a character's humanoid bones in the world, for tests of the page. */
  joints(id: string): Record<string, [number, number, number]>;
  /** The characters on the stage, for tests of the page. */
  list(): readonly CharacterInfo[];
}

export interface CharacterInfo {
  readonly id: string;
  readonly name: string;
  readonly performer: string;
  /** False before the first pose, and while the performer is hidden. */
  readonly isShown: boolean;
  /** 0 in the place of the performer, otherwise beside it. */
  readonly place: number;
}
