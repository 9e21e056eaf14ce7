namespace NeuronMocap.Delivery;

// Takes times that are worth a distribution, for as long as somebody looks at it. Any thread.
internal interface IDurationRecorder
{
    bool IsEnabled { get; }

    // ticks: of Stopwatch.
    void Record(PacketKind kind, long ticks);
}
