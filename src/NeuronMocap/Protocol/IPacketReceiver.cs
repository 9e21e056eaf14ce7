namespace NeuronMocap.Protocol;

// Receives the packets that the receive path finds in a stream of bytes, on the receive thread, in the order of arrival.
internal interface IPacketReceiver
{
    void OnPacket(in ReceivedPacket packet);

    // Bytes of the text stream. For a line with a frame, this is called before OnPacket, with the kind of frame. Otherwise these are bytes between lines.
    void OnText(ReadOnlySpan<byte> bytes, PacketKind kind);

    void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason);
}
