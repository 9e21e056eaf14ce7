namespace NeuronMocap.Frames;

// What the index of a frame says about the frame, compared with those before it.
internal enum IndexChange
{
    // Nothing to compare with: it is the first one, or one of the two has no index.
    None,

    // Ahead of all before it: the next frame, or one behind a gap.
    Ahead,

    // The newest one once more.
    Same,

    // Behind the newest: it came late or twice.
    Late,

    // The server counts anew.
    Restart,
}
