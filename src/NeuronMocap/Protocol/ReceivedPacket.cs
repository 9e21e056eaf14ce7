using System.Runtime.CompilerServices;

namespace NeuronMocap.Protocol;

// One whole packet on its way to the consumers. The bytes belong to the receive buffer and are valid only during the call that hands them over.
// Array, offset and length stand by themselves: a nested segment is copied as a whole right after its parts were written, which stalls the
// processor in every frame.
internal readonly struct ReceivedPacket(PacketKind kind, byte[] array, int offset, int length, long timestamp, int origin)
{
    public ReceivedPacket(PacketKind kind, ArraySegment<byte> bytes, long timestamp, int origin)
        : this(kind, bytes.Array!, bytes.Offset, bytes.Count, timestamp, origin)
    {
    }

    public readonly PacketKind Kind = kind;

    public readonly byte[] Array = array;

    public readonly int Offset = offset;

    public readonly int Length = length;

    public readonly long Timestamp = timestamp;

    // See PacketOrigin.
    public readonly int Origin = origin;

    public int Sender => PacketOrigin.SenderOf(Origin);

    public ReadOnlySpan<byte> Bytes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Array.AsSpan(Offset, Length);
    }

    // Of frames. Calculation packets of either kind have it in the same place.
    public uint AvatarIndex =>
        Kind == PacketKind.Motion ? MotionHeader.ReadAvatarIndex(Bytes) : CalculationHeader.ReadAvatarIndex(Bytes);

    // Whether it came as a line of text: the bytes are then what TextLine made of it, and lack the second token of what comes off the wire.
    public bool IsText => TextLine.IsImage(Bytes);

    // Whether it carries values: commands do not, and a server may send packets of none.
    public bool IsFrame => Kind != PacketKind.Command && Length > ProtocolConstants.HeaderSize;
}
