namespace NeuronMocap.Server.Broadcasting;

// One reader's place in a FrameLog, guarded by the log's lock.
internal sealed class FrameCursor
{
    // Number of the next frame that the reader wants.
    public long Position { get; set; }

    // Frames that were overwritten before the reader came for them.
    public long Missed { get; set; }

    // Whether the reader has something else to do than to wait for a frame.
    public bool IsWoken { get; set; }
}
