using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Clients;

/// <summary>Finds requests in the bytes of a client. A request has 64 bytes between the tokens of a command and may start anywhere.</summary>
/// <remarks>
/// Unlike replies, requests have no payload, whatever their count says. Garbage therefore cannot make the scanner wait for bytes that never come.
/// Not thread-safe.
/// </remarks>
internal sealed class RequestScanner
{
    private readonly byte[] _buffer = new byte[4096];
    private readonly byte[] _request = new byte[ProtocolConstants.HeaderSize];
    private int _count;

    // Room for the next bytes.
    public Memory<byte> Room => Segment;

    // The same room.
    public ArraySegment<byte> Segment => new(_buffer, _count, _buffer.Length - _count);

    // Every byte of the request that was read last.
    public ReadOnlySpan<byte> Request => _request;

    // Takes the bytes that were written to Room.
    public void Advance(int count) => _count += count;

    // Call it until it returns false. Only then is there room again.
    public bool TryRead(out DataCommandHeader request)
    {
        ReadOnlySpan<byte> bytes = _buffer.AsSpan(0, _count);
        int start = 0;
        while (bytes.Length - start >= ProtocolConstants.HeaderSize)
        {
            if (DataCommandHeader.TryRead(bytes[start..], out request))
            {
                bytes.Slice(start, ProtocolConstants.HeaderSize).CopyTo(_request);
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
