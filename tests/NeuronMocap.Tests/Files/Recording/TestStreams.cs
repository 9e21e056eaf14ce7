using System.Diagnostics;

namespace NeuronMocap.Tests.Recording;

// A disk that takes nothing while it is held.
internal sealed class HeldStream : MemoryStream
{
    private readonly ManualResetEventSlim _free = new(initialState: true);
    private volatile bool _isWaitedFor;

    /// <summary>Whether a write waits until the disk is released.</summary>
    public bool IsWaitedFor => _isWaitedFor;

    public void Hold() => _free.Reset();

    public void LetGo() => _free.Set();

    // Writes of spans also come here.
    public override void Write(byte[] buffer, int offset, int count)
    {
        // The disk may be held at any moment before the wait, and during it.
        long start = Stopwatch.GetTimestamp();
        while (!_free.Wait(millisecondsTimeout: 1) && Stopwatch.GetElapsedTime(start) < Limits.Unexpected)
            _isWaitedFor = true;

        _isWaitedFor = false;
        base.Write(buffer, offset, count);
    }
}

// A disk with room for a number of bytes. Like a file on a full disk, it takes what fits, can be shortened, and can be overwritten.
internal sealed class FullStream(int room) : MemoryStream
{
    // Writes of spans also come here.
    public override void Write(byte[] buffer, int offset, int count)
    {
        int taken = Math.Min(count, room - (int)Position);
        base.Write(buffer, offset, taken);
        if (taken < count)
            throw new IOException("No space left on device.");
    }
}
