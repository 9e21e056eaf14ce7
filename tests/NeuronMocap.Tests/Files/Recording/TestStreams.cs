namespace NeuronMocap.Tests.Recording;

// A disk that takes nothing while it is held.
internal sealed class HeldStream : MemoryStream
{
    private readonly ManualResetEventSlim _free = new(initialState: true);
    private volatile bool _isWaitedFor;

    /// <summary>Whether a write waits until the disk is let go.</summary>
    public bool IsWaitedFor => _isWaitedFor;

    public void Hold() => _free.Reset();

    public void LetGo() => _free.Set();

    public override void Write(ReadOnlySpan<byte> buffer)
    {
        _isWaitedFor = !_free.IsSet;
        _free.Wait(Limits.Unexpected);
        _isWaitedFor = false;
        base.Write(buffer);
    }
}

// A disk with room for so many bytes. As a file on a full disk does, it takes what fits, and lets itself be shortened and its bytes be replaced.
internal sealed class FullStream(int room) : MemoryStream
{
    // Spans come here as well.
    public override void Write(byte[] buffer, int offset, int count)
    {
        int taken = Math.Min(count, room - (int)Position);
        base.Write(buffer, offset, taken);
        if (taken < count)
            throw new IOException("No space left on device.");
    }
}
