using NeuronMocap.Server;

namespace NeuronMocap.Tool.Convert;

/// <summary>
/// The times of the frames of a take. They are even, because times of arrival jitter. Where the take continues after a gap, the time of arrival
/// counts again, so a gap keeps its length.
/// </summary>
internal sealed class TakeClock
{
    /// <summary>
    /// The longest time between two frames that counts as a stall. A server that paused continues its numbers. A network that stalls for so long
    /// loses the connection.
    /// </summary>
    public static readonly TimeSpan LongestStall = TimeSpan.FromSeconds(10);

    private readonly double _rate;
    private readonly List<(long Frame, TimeSpan Time)> _runs = [];
    private int _run;

    /// <summary>Creates the clock of a take.</summary>
    /// <param name="take">A take that has an end.</param>
    /// <param name="start">The time of its first frame.</param>
    public TakeClock(MotionSource take, TimeSpan start)
    {
        _rate = take.FrameRate;
        _runs.Add((0, start));
        if (take is RecordingSource recording)
            AddRuns(recording, start);
    }

    /// <summary>Gets the time of a frame. Frames must be asked for in their order.</summary>
    public TimeSpan TimeOf(long frame)
    {
        while (_run + 1 < _runs.Count && _runs[_run + 1].Frame <= frame)
            _run++;

        return TimeInRun(frame);
    }

    private TimeSpan TimeInRun(long frame) => _runs[_run].Time + FrameTimes.Of(frame - _runs[_run].Frame, _rate);

    private void AddRuns(RecordingSource recording, TimeSpan start)
    {
        var breaks = recording.Gaps.Where(static gap => !gap.IsFilled).Select(static gap => gap.Frame).ToHashSet();
        TimeSpan before = recording.GetTime(0);
        TimeSpan offset = start - before;
        for (long frame = 1; frame < recording.FrameCount; frame++)
        {
            TimeSpan arrival = recording.GetTime(frame);
            if (breaks.Contains(frame) || arrival - before > LongestStall)
            {
                // Times do not go back, even if the rate of the run before was too low.
                TimeSpan earliest = TimeInRun(frame);
                _runs.Add((frame, arrival + offset > earliest ? arrival + offset : earliest));
                _run = _runs.Count - 1;
            }

            before = arrival;
        }

        _run = 0;
    }
}
