using System.Diagnostics;

namespace NeuronMocap.Recording;

// Tracks the position of a playback and computes when a recorded time is due. Due times are computed from the position and instant at which the
// clock was last set. Rounding errors and late wake-ups therefore never add up. Instants are Stopwatch ticks. Not thread-safe.
internal sealed class PlaybackClock(bool catchesUp = false)
{
    // After a longer delay, by a handler or because the computer slept, the missed time is not caught up, unless the program moves the clock itself.
    private static readonly long MostBehind = Stopwatch.Frequency;

    private TimeSpan _position;
    private long _anchor;
    private TimeSpan _reached;
    private long _newest;
    private long _shift;

    public double Speed { get; private set; } = 1;

    public bool IsPaced => !double.IsPositiveInfinity(Speed);

    public bool IsRunning { get; private set; }

    public TimeSpan PositionAt(long now)
    {
        if (!IsPaced)
            return _reached;

        if (!IsRunning || now <= _anchor)
            return _position;

        double passed = (now - _anchor) / (double)Stopwatch.Frequency * Speed * TimeSpan.TicksPerSecond;
        return new TimeSpan(RecordedTime.Add(_position.Ticks, RecordedTime.ToTicks(passed)));
    }

    public void Run(long now)
    {
        MoveTo(PositionAt(now), now);
        IsRunning = true;
    }

    public void Halt(long now)
    {
        MoveTo(PositionAt(now), now);
        IsRunning = false;
    }

    public void SetSpeed(double speed, long now)
    {
        MoveTo(PositionAt(now), now);
        Speed = speed;
    }

    // Sets the position that is due at an instant.
    public void MoveTo(TimeSpan position, long instant)
    {
        _position = position;
        _reached = position;
        _anchor = instant;
        _shift = Math.Max(0, _newest - instant);
    }

    // Without pacing, recorded time and real time advance at the same rate.
    public long DueAt(TimeSpan time) =>
        RecordedTime.Add(_anchor, RecordedTime.ToTicks(Math.Round((time - _position).TotalSeconds / (IsPaced ? Speed : 1) * Stopwatch.Frequency)));

    // Records that an event was reached and returns its timestamp, which is the time when it was or is due. Timestamps never decrease. Unpaced
    // playback moves them ahead of real time, and they stay ahead.
    public long Reach(TimeSpan time, long now)
    {
        if (IsPaced && !catchesUp && DueAt(time) < now - MostBehind)
            MoveTo(time, now);

        _reached = time;
        _newest = Math.Max(_newest, RecordedTime.Add(DueAt(time), _shift));
        return _newest;
    }
}
