using NeuronMocap.Server;

namespace NeuronMocap.Tool.Convert;

/// <summary>
/// The times of the frames of a take. They are even, because times of arrival jitter. A gap or a pause keeps its length, also if the clock of the
/// server differs from the usual rate.
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
            AddRuns(recording, first);
    }

    /// <summary>Gets the time of a frame. Frames must be asked for in their order.</summary>
    public TimeSpan TimeOf(long frame)
    {
        while (_run + 1 < _runs.Count && _runs[_run + 1].Frame <= frame)
            _run++;

        return TimeInRun(frame);
    }

    private TimeSpan TimeInRun(long frame) => _runs[_run].Time + FrameTimes.Of(frame - _runs[_run].Frame, _rate);

    private void AddRuns(RecordingSource recording, long first)
    {
        foreach ((long frame, TimeSpan length) in FindBreaks(recording, first))
        {
            // Times do not go back.
            TimeSpan earliest = TimeInRun(frame);
            TimeSpan time = Align(earliest + length);
            _runs.Add((frame, time > earliest ? time : earliest));
            _run = _runs.Count - 1;
        }

        _run = 0;
    }

    private static IEnumerable<Pause> FindBreaks(RecordingSource recording, long first)
    {
        double rate = recording.MeasuredFrameRate ?? recording.FrameRate;
        var gaps = recording.Gaps.Where(gap => gap.Frame > first).ToDictionary(static gap => gap.Frame);
        var interpolated = gaps.Values.Where(static gap => gap.IsFilled).SelectMany(static gap => Frames(gap.Frame - gap.Missing!.Value, gap.Frame)).ToHashSet();
        var pauses = new PauseFinder(() => rate);
        List<Pause> breaks = [];
        for (long frame = first; frame < recording.FrameCount; frame++)
        {
            if (interpolated.Contains(frame))
                continue;

            TimeSpan time = recording.GetTime(frame);
            if (gaps.TryGetValue(frame, out RecordedGap gap) && !gap.IsFilled)
            {
                breaks.Add(new Pause(frame, time - recording.GetTime(frame - 1) - FrameTimes.Of(1, rate)));
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
