namespace NeuronMocap.Server.Broadcasting;

// The position of one reader in a FrameLog. The log's lock guards it, except for the signal.
internal sealed class FrameCursor
{
    private readonly object _signalLock = new();
    private bool _isSignalled;

    // Number of the frame that the reader wants next, and the part of it that the reader already has.
    public long Position { get; private set; }

    public int Bytes { get; private set; }

    public int Packets { get; private set; }

    // Packets that were overwritten before the reader read them.
    public long Missed { get; private set; }

    // Whether the reader has other work than to wait for a frame.
    public bool IsWoken { get; set; }

    // Whether the reader waits for a signal, or is about to.
    public bool IsWaiting { get; set; }

    // Takes units while the reader waits. Null if only the reader's own thread can.
    public IDirectRecipient? Direct { get; set; }

    public static FrameCursor At(long position) => new() { Position = position };

    // Moves to the start of a later frame.
    public void Skip(long position, long missed)
    {
        MoveTo(position);
        Missed += missed;
    }

    public void MoveTo(long position) => (Position, Bytes, Packets) = (position, 0, 0);

    public void MoveWithin(int bytes, int packets) => (Bytes, Packets) = (bytes, packets);

    // Ends the current wait, or else the next one. Any thread.
    public void Signal()
    {
        lock (_signalLock)
        {
            _isSignalled = true;
            Monitor.Pulse(_signalLock);
        }
    }

    public void Wait()
    {
        lock (_signalLock)
        {
            while (!_isSignalled)
                Monitor.Wait(_signalLock);

            _isSignalled = false;
        }
    }
}
