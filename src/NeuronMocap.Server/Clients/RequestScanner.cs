using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Clients;

/// <summary>
/// Finds requests in what a client sends: 64 bytes between the tokens of a command, wherever they begin. Unlike replies they have no payload,
/// whatever their count says, so that no garbage makes the scanner wait for bytes that never come. Not thread-safe.
/// </summary>
internal sealed class RequestScanner
{
    private readonly byte[] _buffer = new byte[4096];
    private int _count;

    // Where the next bytes go.
    public Memory<byte> Room => _buffer.AsMemory(_count);

    // Takes the bytes that were put there.
    public void Advance(int count) => _count += count;

    // Asked until there is none; only then is there room again.
    public bool TryRead(out DataCommandHeader request)
    {
        ReadOnlySpan<byte> bytes = _buffer.AsSpan(0, _count);
        int start = 0;
        while (bytes.Length - start >= ProtocolConstants.HeaderSize)
        {
            if (DataCommandHeader.TryRead(bytes[start..], out request))
            {
                Drop(start + ProtocolConstants.HeaderSize);
                return true;
            }

            int next = bytes[(start + 1)..].IndexOf(ProtocolConstants.TokenStart);
            start = next < 0 ? bytes.Length : start + 1 + next;
        }

        Drop(Math.Min(start, _count));
        request = default;
        return false;
    }

    private void Drop(int count)
    {
        _count -= count;
        _buffer.AsSpan(count, _count).CopyTo(_buffer);
    }
}
