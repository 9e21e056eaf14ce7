namespace NeuronMocap.Tests.Recording;

// A disk that takes nothing while it is held.
internal sealed class HeldStream : MemoryStream
{
    private readonly ManualResetEventSlim _free = new(initialState: true);

    public void Hold() => _free.Reset();

    public void LetGo() => _free.Set();

    public override void Write(ReadOnlySpan<byte> buffer)
    {
        _free.Wait(Limits.Unexpected);
        base.Write(buffer);
    }
}

// A disk with room for so many bytes.
internal sealed class FullStream(int room) : MemoryStream
{
    public override void Write(ReadOnlySpan<byte> buffer)
    {
        int left = room - (int)Length;
        if (buffer.Length <= left)
        {
            base.Write(buffer);
            return;
        }

        // As a file does: what fits is written.
        base.Write(buffer[..left]);
        throw new IOException("No space left on device.");
    }
}
