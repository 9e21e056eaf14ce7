using NeuronMocap.Recording;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Publishes the units of a recording when they arrived.</summary>
/// <param name="streams">The recording, or its parts, and where to publish them.</param>
/// <param name="options">Speed and loop.</param>
/// <param name="ended">As the base has it.</param>
/// <param name="report">As the base has it.</param>
/// <param name="time">The time; null for the real one.</param>
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

    // False when the broadcast is stopped first.
    private bool PublishPass(RecordedUnits units)
    {
        while (units.TryRead(out ReadOnlySpan<byte> unit, out TimeSpan due))
        {
            if (!WaitFor(due))
                return false;

            foreach ((RecordingContent content, FrameLog log) in streams)
            {
                if (content.Takes(units))
                    log.Publish(unit);
            }
        }

        return true;
    }

    private bool WaitFor(TimeSpan due)
    {
        lock (Gate)
        {
            while (!IsStopping && _clock.DueAt(due) is var instant && instant > _time.Now)
                _time.Wait(Gate, instant);

            _clock.Reach(due, _time.Now);
            return !IsStopping;
        }
    }
}
