namespace NeuronMocap.Server.Broadcasting;

// One reader's place in a FrameLog, guarded by the log's lock.
internal sealed class FrameCursor
{
    // Number of the frame that the reader wants, and what it has had of it.
    public long Position { get; private set; }

    public int Bytes { get; private set; }

    public int Packets { get; private set; }

    // Packets that were overwritten before the reader came for them.
    public long Missed { get; private set; }

    // Whether the reader has something else to do than to wait for a frame.
    public bool IsWoken { get; set; }

    public static FrameCursor At(long position) => new() { Position = position };

    // To the start of a later frame.
    public void Skip(long position, long missed)
    {
        MoveTo(position);
        Missed += missed;
    }

    public void MoveTo(long position) => (Position, Bytes, Packets) = (position, 0, 0);

    public void MoveWithin(int bytes, int packets) => (Bytes, Packets) = (bytes, packets);
}
