using NeuronMocap.Protocol;

namespace NeuronMocap.Commands;

// Finds the packets in the bytes of a command connection, however they are split: replies on a client, requests on a server. It skips bytes that are not a
// header, up to the next place that has both tokens. Memory grows with the received bytes, not with the size that a header announces.
internal sealed class CommandPacketReader(int maxPayload)
{
    private byte[] _buffer = new byte[1024];
    private int _start;
    private int _end;

    public long Skipped { get; private set; }

    // Whether no bytes are left.
    public bool IsEmpty => _start == _end;

    // Returns room for the next bytes; call Add after it is filled.
    public ArraySegment<byte> GetRoom()
    {
        if (_start > 0)
        {
            _buffer.AsSpan(_start, _end - _start).CopyTo(_buffer);
            _end -= _start;
            _start = 0;
        }

        if (_end == _buffer.Length)
            Array.Resize(ref _buffer, 2 * _buffer.Length);

        return new ArraySegment<byte>(_buffer, _end, _buffer.Length - _end);
    }

    public void Add(int count) => _end += count;

    // Returns false if more bytes are needed. A header with a negative or too large size is returned without a payload, and nothing can be read after it.
    // The payload is valid until the next call of GetRoom.
    public bool TryRead(out CommandChannelHeader header, out ReadOnlySpan<byte> payload)
    {
        payload = default;
        ReadOnlySpan<byte> bytes = _buffer.AsSpan(_start, _end - _start);
        int at = FindHeader(bytes, out header);
        _start += at;
        Skipped += at;
        bytes = bytes[at..];
        if (bytes.Length < CommandChannelHeader.Size)
            return false;
        if (!IsAllowed(header))
            return true;
        if (bytes.Length - CommandChannelHeader.Size < header.PayloadSize)
            return false;

        payload = bytes.Slice(CommandChannelHeader.Size, header.PayloadSize);
        _start += CommandChannelHeader.Size + header.PayloadSize;
        return true;
    }

    public bool IsAllowed(in CommandChannelHeader header) => header.PayloadSize >= 0 && header.PayloadSize <= maxPayload;

    // Finds a header, or the place where an incomplete header may begin.
    private static int FindHeader(ReadOnlySpan<byte> bytes, out CommandChannelHeader header)
    {
        header = default;
        for (int at = 0; ; at++)
        {
            int next = bytes[at..].IndexOf(ProtocolConstants.TokenStart);
            if (next < 0)
                return bytes.Length;

            at += next;
            if (bytes.Length - at < CommandChannelHeader.Size || CommandChannelHeader.TryRead(bytes[at..], out header))
                return at;
        }
    }
}
