namespace NeuronMocap.Protocol;

// In front of who receives from a calculation port: motion that comes there too would be that of the first connection once more.
internal sealed class CalculationOnlyReceiver(IPacketReceiver receiver) : IPacketReceiver
{
    // The bytes of a line were told before it.
    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.Kind != PacketKind.Motion)
            receiver.OnPacket(packet);
        else if (!packet.IsText)
            receiver.OnSkipped(packet.Bytes, SkipReason.NotCalculation);
    }

    public void OnText(ReadOnlySpan<byte> bytes) => receiver.OnText(bytes);

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason) => receiver.OnSkipped(bytes, reason);
}
