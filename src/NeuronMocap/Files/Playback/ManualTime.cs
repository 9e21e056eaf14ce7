namespace NeuronMocap.Recording;

// The time of a playback that follows a program's clock. The player wakes its threads when the clock has moved.
internal sealed class ManualTime(ManualClock clock) : PlaybackTime
{
    public override long Now => clock.Timestamp;

    public override void Wait(object gate, long instant) => Monitor.Wait(gate);
}
