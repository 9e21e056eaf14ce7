namespace NeuronMocap.Server.Clients;

// What one recipient, or several together, have been sent and have lost.
internal readonly record struct RecipientCounters(
    long FramesSent, long CalculationFramesSent, long PacketsDropped, long BytesSent, long RepliesSent, long RequestsIgnored, long RequestsDropped)
{
    public RecipientCounters Add(in RecipientCounters other) => new(
        FramesSent + other.FramesSent,
        CalculationFramesSent + other.CalculationFramesSent,
        PacketsDropped + other.PacketsDropped,
        BytesSent + other.BytesSent,
        RepliesSent + other.RepliesSent,
        RequestsIgnored + other.RequestsIgnored,
        RequestsDropped + other.RequestsDropped);
}
