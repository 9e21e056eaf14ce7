namespace NeuronMocap.Delivery;

// Records the intervals between frames. The listener of the histogram is code of the application.
internal sealed class ReportedIntervals(IDurationRecorder recorder, HandlerThread thread) : IDurationRecorder
{
    public bool IsEnabled => recorder.IsEnabled;

    public void Record(PacketKind kind, long ticks)
    {
        thread.Enter();
        recorder.Record(kind, ticks);
        thread.Leave();
    }
}
