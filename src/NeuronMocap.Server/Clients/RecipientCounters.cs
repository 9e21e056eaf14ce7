namespace NeuronMocap.Server.Clients;

// What one recipient, or several together, have been sent and have lost.
internal readonly struct RecipientCounters(long framesSent, long packetsDropped, long bytesSent)
{
    public long FramesSent { get; } = framesSent;

    public long PacketsDropped { get; } = packetsDropped;

    public long BytesSent { get; } = bytesSent;

    public RecipientCounters Add(RecipientCounters other) =>
        new(FramesSent + other.FramesSent, PacketsDropped + other.PacketsDropped, BytesSent + other.BytesSent);
}
