namespace NeuronMocap.Protocol;

// Where the receive path delivers what it found, on the receive thread, in the order of arrival.
internal interface IPacketReceiver
{
    // Where every piece of bytes is shown before it is looked at; null where nobody can record it. Always the same one.
    StreamTap? Tap { get; }

    // A new connection stands; what comes over it does not continue what came before.
    void OnLinkOpened();

    // The connection is gone, or never came to stand.
    void OnLinkClosed();

    void OnPacket(in ReceivedPacket packet);

    // Bytes of the text stream, before OnPacket where they are a line with a frame; else what stands between lines.
    void OnText(ReadOnlySpan<byte> bytes);

    void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason);
}
