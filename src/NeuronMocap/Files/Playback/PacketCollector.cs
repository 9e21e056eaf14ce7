using NeuronMocap.Delivery;
using NeuronMocap.Protocol;

namespace NeuronMocap.Recording;

// Counts the packets of an arrival and keeps its frames until they are requested. An assembler delivers all packets of an arrival at once, in
// memory that it reuses.
internal sealed class PacketCollector(StreamCounters counters) : IPacketReceiver
{
    private readonly List<(ReceivedPacket Packet, int Start)> _packets = [];
    private byte[] _bytes = [];
    private int _length;
    private int _next;

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind) => counters.CountText(bytes.Length);

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason) => counters.CountSkipped(bytes.Length, reason);

    public void OnPacket(in ReceivedPacket packet)
    {
        counters.Count(packet);
        if (!packet.IsFrame)
            return;

        if (_bytes.Length - _length < packet.Length)
            Array.Resize(ref _bytes, Math.Max(_length + packet.Length, 2 * _bytes.Length));

        packet.Bytes.CopyTo(_bytes.AsSpan(_length));
        _packets.Add((packet, _length));
        _length += packet.Length;
    }

    // Valid until the next packet is taken.
    public bool TryTake(out ReceivedPacket packet)
    {
        if (_next == _packets.Count)
        {
            _packets.Clear();
            _next = 0;
            _length = 0;
            packet = default;
            return false;
        }

        (ReceivedPacket found, int start) = _packets[_next++];
        packet = new ReceivedPacket(found.Kind, _bytes, start, found.Length, found.Timestamp, found.Origin);
        return true;
    }
}
