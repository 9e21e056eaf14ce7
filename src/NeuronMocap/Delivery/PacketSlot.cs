using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Memory for one packet that is used again and again; it grows to the largest packet it has held.
internal struct PacketSlot(int capacity)
{
    private byte[] _bytes = new byte[capacity];
    private int _length;
    private PacketKind _kind;
    private long _timestamp;
    private int _origin;

    public readonly ReceivedPacket Packet => new(_kind, _bytes, 0, _length, _timestamp, _origin);

    public void Store(in ReceivedPacket packet)
    {
        if (_bytes.Length < packet.Length)
            _bytes = new byte[packet.Length];

        packet.Bytes.CopyTo(_bytes);
        _length = packet.Length;
        _kind = packet.Kind;
        _timestamp = packet.Timestamp;
        _origin = packet.Origin;
    }
}
