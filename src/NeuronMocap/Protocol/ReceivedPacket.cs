namespace NeuronMocap.Protocol;

// One whole packet on its way to the consumers. The bytes belong to the receive buffer and are valid only during the call that hands them over.
internal readonly record struct ReceivedPacket(PacketKind Kind, ArraySegment<byte> Bytes, long Timestamp, int Source)
{
    // Whether it carries values: commands do not, and a server may send packets of none.
    public bool IsFrame => Kind != PacketKind.Command && Bytes.Count > ProtocolConstants.HeaderSize;
}
