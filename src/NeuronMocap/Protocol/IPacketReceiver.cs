namespace NeuronMocap.Protocol;

// Where the receive path delivers what it found in a stream of bytes: on the receive thread, in the order of arrival.
internal interface IPacketReceiver
{
    void OnPacket(in ReceivedPacket packet);

    // Bytes of the text stream, before OnPacket where they are a line with a frame; else what stands between lines.
    void OnText(ReadOnlySpan<byte> bytes);

    void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason);
}
