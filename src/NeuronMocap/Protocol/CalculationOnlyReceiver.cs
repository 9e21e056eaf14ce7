namespace NeuronMocap.Protocol;

// Filters the packets of a calculation port. Motion on this port would repeat the motion of the first connection.
internal sealed class CalculationOnlyReceiver(IPacketReceiver receiver) : IPacketReceiver
{
    // OnText has already skipped the bytes of a line of text.
    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.Kind != PacketKind.Motion)
            receiver.OnPacket(packet);
        else if (!packet.IsText)
            receiver.OnSkipped(packet.Bytes, SkipReason.NotCalculation);
    }

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
    {
        if (kind == PacketKind.Motion)
            receiver.OnSkipped(bytes, SkipReason.NotCalculation);
        else
            receiver.OnText(bytes, kind);
    }

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason) => receiver.OnSkipped(bytes, reason);
}
