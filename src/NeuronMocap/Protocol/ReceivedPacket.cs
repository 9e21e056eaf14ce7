namespace NeuronMocap.Protocol;

// One whole packet on its way to the consumers. The bytes belong to the receive buffer and are valid only during the call that hands them over.
internal readonly record struct ReceivedPacket(PacketKind Kind, ArraySegment<byte> Bytes, long Timestamp, int Source);
