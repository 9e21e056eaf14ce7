// The messages of the socket /control and the answers of /api.

export type Vector = readonly [number, number, number];

export interface BoneInfo {
  readonly name: string;
  /** Name of the parent, which comes earlier in the list; null for the hips. */
  readonly parent: string | null;
  /** Position relative to the parent in the rest pose, in metres. */
  readonly offset: Vector;
}

export interface PerformerInfo {
  readonly key: string;
  readonly name: string;
  /** The number in the performer's compact poses. */
  readonly index: number;
  /** #rrggbb */
  readonly colour: string;
  readonly variant: "Neck1" | "Spine3";
  readonly bones: readonly BoneInfo[];
}

export interface Hello {
  readonly name: string;
  readonly version: string;
  readonly mode: "live" | "take";
  readonly source: string;
  readonly take?: string;
  readonly canCommand: boolean;
  /** Bytes of the largest take that the server takes. */
  readonly uploadLimit?: number;
  readonly performers: readonly PerformerInfo[];
}

export interface PerformerRates {
  readonly key: string;
  /** Frames per second that arrive at the server. */
  readonly fps: number;
  /** Milliseconds. */
  readonly latency: number | null;
  readonly jitter: number | null;
  /** Frames that never arrived. */
  readonly lost: number;
  /** Frames that arrived too late, after a newer one. */
  readonly dropped: number;
}

export interface Status {
  /** created, connecting, connected, receiving, silent, waiting or stopped. */
  readonly state: string;
  /** The state or the problem in a few words. */
  readonly words: string;
  /** What to check, in sentences. Empty if nothing is wrong. */
  readonly advice: string;
  readonly address: string;
  readonly performers: readonly PerformerRates[];
  readonly bytesPerSecond: number;
  readonly reconnects: number;
  /** Poses that pages did not get because they, or their network, were too slow. */
  readonly dropped?: number;
}

export interface Recording {
  readonly state: string;
  readonly file?: string | null;
  readonly seconds: number;
  readonly bytes: number;
  /** Frames that arrived during the recording. */
  readonly frames: number;
  readonly take?: string | null;
}

export interface Contact {
  readonly key: string;
  readonly left: boolean;
  readonly right: boolean;
}

export type ServerMessage =
  | ({ readonly type: "hello" } & Hello)
  | ({ readonly type: "performer" } & PerformerInfo)
  | { readonly type: "gone"; readonly key: string }
  | ({ readonly type: "status" } & Status)
  | ({ readonly type: "contact" } & Contact)
  | ({ readonly type: "recording" } & Recording)
  | { readonly type: "take"; readonly id: string }
  | { readonly type: "problem"; readonly text: string }
  /** `time` is the server's clock, in Unix milliseconds. */
  | { readonly type: "pong"; readonly t: number; readonly time?: number };
