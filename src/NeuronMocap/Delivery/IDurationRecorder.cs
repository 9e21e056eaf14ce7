namespace NeuronMocap.Delivery;

// Records durations for a histogram while a listener is active. Any thread.
internal interface IDurationRecorder
{
    bool IsEnabled { get; }

    // ticks: in ticks of Stopwatch.
    void Record(PacketKind kind, long ticks);
}
