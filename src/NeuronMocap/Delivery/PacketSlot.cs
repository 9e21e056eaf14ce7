using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Memory for one packet that is used again and again; it grows to the largest packet it has held.
internal struct PacketSlot(int capacity)
{
    private byte[] _bytes = new byte[capacity];
    private int _length;
    private PacketKind _kind;
    private long _timestamp;
    private int _source;

    public readonly ReceivedPacket Packet => new(_kind, new ArraySegment<byte>(_bytes, 0, _length), _timestamp, _source);

    public void Store(in ReceivedPacket packet)
    {
        ArraySegment<byte> bytes = packet.Bytes;
        if (_bytes.Length < bytes.Count)
            _bytes = new byte[bytes.Count];

        bytes.AsSpan().CopyTo(_bytes);
        _length = bytes.Count;
        _kind = packet.Kind;
        _timestamp = packet.Timestamp;
        _source = packet.Source;
    }
}
