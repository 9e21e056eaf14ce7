namespace NeuronMocap.Frames;

// What a frame's index says about the frame, compared with earlier frames.
internal enum IndexChange
{
    // The index cannot be compared: this is the first frame, or one of the two frames has no index.
    None,

    // Later than all earlier frames: the next frame, or the first frame after a gap.
    Ahead,

    // The newest frame again.
    Same,

    // Earlier than the newest frame: it arrived late or twice.
    Late,

    // The server restarted its count.
    Restart,
}
