import type { ConnectionState } from "../live/connection";
import type { Status } from "../live/messages";
import type { TakeInfo } from "../takes/info";

export type Tone = "good" | "busy" | "warning" | "bad";

/** What the page tells about the stream, and what to do. */
export interface Situation {
  readonly tone: Tone;
  /** A few words. */
  readonly title: string;
  readonly text: string;
  /** What the reader of the page can do. Empty if there is nothing to do. */
  readonly advice: string;
  /** False if all is well: the stage needs no message. */
  readonly needsWords: boolean;
}

/** Puts the state of the connection and of the source into words. */
export function describe(connection: ConnectionState, refusal: string, status: Status | null, performers: number): Situation {
  switch (connection) {
    case "denied":
      return say("bad", "This link does not work", refusal, "Open the link that neuron-mocap view shows in its terminal, with the token at its end.");
    case "gone":
      return say("bad", "The program does not answer", "The page connects again by itself.",
        "If neuron-mocap view has ended, start it again with the same port.");
    case "connecting":
    case "hidden":
      return say("busy", "Connecting to the program", "", "");
    case "open":
      return status === null ? say("busy", "Connecting to the program", "", "") : ofSource(status, performers);
  }
}

/** Whether the program is connected to the source. A silent source is. */
export function isConnected(status: Status | null): boolean {
  return status !== null && ["connected", "receiving", "silent"].includes(status.state.toLowerCase());
}

/** Tells about a take what the stage must say. A take that the program still reads may get frames. */
export function describeTake(take: TakeInfo | null): Situation {
  return take !== null && take.progress >= 1 && take.performers.every(performer => performer.frames === 0)
    ? say("warning", "This take has no frames", take.problems[0] ?? "", "Open another file.")
    : { tone: "good", title: "Take", text: "", advice: "", needsWords: false };
}

// The words and the advice of the server are those of neuron-mocap watch. The texts here stand in where it has none.
function ofSource(status: Status, performers: number): Situation {
  const { words, advice } = status;
  const tell = (tone: Tone, title: string, fallback: string): Situation => say(tone, words || title, "", advice || fallback);
  switch (status.state.toLowerCase()) {
    case "receiving":
      if (advice)
        return tell("warning", "Receiving", "");
      return performers > 0
        ? { tone: "good", title: words || "Receiving", text: "", advice: "", needsWords: false }
        : say("warning", "No performer yet", "The source answers, but sends no motion of a performer.",
          "Open a character in Axis Studio or Axis Neuron, and check that it broadcasts.");
    case "created":
    case "connecting":
      return tell("busy", "Connecting to the source", "");
    case "connected":
      return tell("busy", "Waiting for motion", "Turn on broadcasting in Axis Studio or Axis Neuron.");
    case "silent":
      return tell("warning", "No motion arrives", "Check that the suit is connected, and that Axis Studio or Axis Neuron broadcasts.");
    case "waiting":
      return tell("bad", "Connection lost", "Check that Axis Studio or Axis Neuron runs. The connection returns by itself.");
    default:
      return tell("warning", "The source has ended", "Start the program again to see it once more.");
  }
}

function say(tone: Tone, title: string, text: string, advice: string): Situation {
  return { tone, title, text, advice, needsWords: true };
}
