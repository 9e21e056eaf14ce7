namespace NeuronMocap.Server.Clients;

// Counts what one or more recipients were sent and what they missed.
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
