using NeuronMocap.Recording;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Publishes the units of a recording at the times at which they arrived.</summary>
/// <param name="streams">The recording or its parts, and the logs to publish to.</param>
/// <param name="options">Speed and loop.</param>
/// <param name="ended">See the base class.</param>
/// <param name="report">See the base class.</param>
/// <param name="time">The clock; null for the real one.</param>
internal sealed class RecordingPacer(
    IReadOnlyList<(RecordingContent Content, FrameLog Log)> streams, BroadcasterOptions options, Action<Exception?> ended, FaultReport report, PlaybackTime? time = null)
    : Pacer(ended, report)
{
    private readonly PlaybackTime _time = time ?? PlaybackTime.Real;
    private readonly PlaybackClock _clock = new();

    protected override void PublishAll()
    {
        using TimerResolution resolution = TimerResolution.Raise();
        using RecordedUnits units = streams[0].Content.OpenUnits();
        _clock.SetSpeed(options.RecordingSpeed, _time.Now);
        _clock.Run(_time.Now);
        while (PublishPass(units) && options.LoopRecording && WaitFor(units.Duration))
        {
            units.Rewind();
            _clock.MoveTo(TimeSpan.Zero, _clock.DueAt(units.Duration));
        }
    }

    // Returns false when the broadcast is stopped first.
    private bool PublishPass(RecordedUnits units)
    {
        while (units.TryRead(out ReadOnlySpan<byte> unit, out TimeSpan due))
        {
            if (!WaitFor(due))
                return false;

            foreach ((RecordingContent content, FrameLog log) in streams)
            {
                if (content.Takes(units.IsCalculation))
                    log.Publish(unit);
            }
        }

        return true;
    }

    private bool WaitFor(TimeSpan due)
    {
        lock (Lock)
        {
            while (!IsStopping && _clock.DueAt(due) is var instant && instant > _time.Now)
                _time.Wait(Lock, instant);

            _clock.Reach(due, _time.Now);
            return !IsStopping;
        }
    }
}
