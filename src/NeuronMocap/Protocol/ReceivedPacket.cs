using System.Runtime.CompilerServices;

namespace NeuronMocap.Protocol;

// One complete packet on its way to the consumers. Its bytes belong to the receive buffer and are valid only during the call that delivers them. Array,
// offset and length are separate fields. A nested segment would be copied as a whole directly after its parts were written, which stalls the processor in
// every frame.
internal readonly struct ReceivedPacket(PacketKind kind, byte[] array, int offset, int length, long timestamp, int origin)
{
    public ReceivedPacket(PacketKind kind, ArraySegment<byte> bytes, long timestamp, int origin)
        : this(kind, bytes.Array!, bytes.Offset, bytes.Count, timestamp, origin)
    {
    }

    public ReceivedPacket(PacketKind kind, byte[] bytes, long timestamp, int origin)
        : this(kind, bytes, offset: 0, bytes.Length, timestamp, origin)
    {
    }

    public readonly PacketKind Kind = kind;

    public readonly byte[] Array = array;

    public readonly int Offset = offset;

    public readonly int Length = length;

    public readonly long Timestamp = timestamp;

    // The PacketOrigin.
    public readonly int Origin = origin;

    public int Sender => PacketOrigin.SenderOf(Origin);

    public ReadOnlySpan<byte> Bytes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Array.AsSpan(Offset, Length);
    }

    // The compiler knows its length, so reading a field checks no bound.
    public ReadOnlySpan<byte> Header
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Array.AsSpan(Offset, ProtocolConstants.HeaderSize);
    }

    // For frames only. Both kinds of calculation packets have the index in the same place.
    public uint AvatarIndex =>
        Kind == PacketKind.Motion ? MotionHeader.ReadAvatarIndex(Header) : CalculationHeader.ReadAvatarIndex(Header);

    // Whether the packet arrived as a line of text. TextLine then made the bytes, and they lack the second token that binary packets have.
    public bool IsText => TextLine.IsImage(Header);

    // Whether the packet has values. Commands have none, and a server can send other packets without values.
    public bool IsFrame => Kind != PacketKind.Command && Length > ProtocolConstants.HeaderSize;
}
