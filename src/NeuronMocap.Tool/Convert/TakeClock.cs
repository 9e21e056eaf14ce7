using NeuronMocap.Server;

namespace NeuronMocap.Tool.Convert;

/// <summary>
/// The times of the frames of a take. They are even, because times of arrival jitter. Where the take continues after a gap or a pause, the time of
/// arrival counts again, so the gap keeps its length.
/// </summary>
internal sealed class TakeClock
{
    private readonly double _rate;
    private readonly TakeClock? _other;
    private readonly List<(long Frame, TimeSpan Time)> _runs = [];
    private int _run;

    /// <summary>Creates the clock of a take.</summary>
    /// <param name="take">A take that has an end.</param>
    /// <param name="first">The first frame that is asked for.</param>
    /// <param name="start">The time of that frame.</param>
    /// <param name="other">The clock of an avatar of the same server; null if there is none. Avatars move at the same instants.</param>
    public TakeClock(MotionSource take, long first, TimeSpan start, TakeClock? other)
    {
        _rate = take.FrameRate;
        _other = other is not null && other._rate == _rate ? other : null;
        _runs.Add((first, Align(start)));
        if (take is RecordingSource recording)
            AddRuns(recording, first, start);
    }

    /// <summary>Gets the time of a frame. Frames must be asked for in their order.</summary>
    public TimeSpan TimeOf(long frame)
    {
        while (_run + 1 < _runs.Count && _runs[_run + 1].Frame <= frame)
            _run++;

        return TimeInRun(frame);
    }

    private TimeSpan TimeInRun(long frame) => _runs[_run].Time + FrameTimes.Of(frame - _runs[_run].Frame, _rate);

    private void AddRuns(RecordingSource recording, long first, TimeSpan start)
    {
        TimeSpan offset = start - recording.GetTime(first);
        foreach ((long frame, TimeSpan time) in FindBreaks(recording, first))
        {
            // Times do not go back, even if the rate of the run before was too low.
            TimeSpan earliest = TimeInRun(frame);
            TimeSpan arrival = Align(time + offset);
            _runs.Add((frame, arrival > earliest ? arrival : earliest));
            _run = _runs.Count - 1;
        }

        _run = 0;
    }

    private static IEnumerable<Pause> FindBreaks(RecordingSource recording, long first)
    {
        var gaps = recording.Gaps.Where(gap => gap.Frame > first).ToDictionary(static gap => gap.Frame);
        var interpolated = gaps.Values.Where(static gap => gap.IsFilled).SelectMany(static gap => Frames(gap.Frame - gap.Missing!.Value, gap.Frame)).ToHashSet();
        var pauses = new PauseFinder(() => recording.FrameRate);
        List<Pause> breaks = [];
        for (long frame = first; frame < recording.FrameCount; frame++)
        {
            if (interpolated.Contains(frame))
                continue;

            TimeSpan time = recording.GetTime(frame);
            if (gaps.TryGetValue(frame, out RecordedGap gap) && !gap.IsFilled)
            {
                breaks.Add(new Pause(frame, time));
                pauses.Start();
            }

            pauses.Add(frame, frame, time);
        }

        pauses.Finish();
        return breaks.Concat(pauses.Pauses).OrderBy(static found => found.Frame);
    }

    private static IEnumerable<long> Frames(long first, long end)
    {
        for (long frame = first; frame < end; frame++)
            yield return frame;
    }

    // Frames of several avatars arrive one after the other. The distance to the other avatar is whole frames.
    private TimeSpan Align(TimeSpan time)
    {
        if (_other is null)
            return time;

        int run = _other._runs.FindLastIndex(run => run.Time - PauseFinder.ShortestPause <= time);
        TimeSpan near = _other._runs[Math.Max(run, 0)].Time;
        return near + FrameTimes.Of((long)Math.Round((time - near).TotalSeconds * _rate), _rate);
    }
}
