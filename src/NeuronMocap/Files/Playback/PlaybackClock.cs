using System.Diagnostics;

namespace NeuronMocap.Recording;

// Where a playback stands, and when a recorded time is due. Due times are computed afresh from the place and instant where the clock was set last,
// so that rounding and late wake-ups never add up. Instants are ticks of Stopwatch. Not thread-safe.
internal sealed class PlaybackClock
{
    // Who was held up for longer than this, by a handler or because the computer slept, does not get it all at once.
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

        return IsRunning && now > _anchor ? _position + TimeSpan.FromSeconds((now - _anchor) / (double)Stopwatch.Frequency * Speed) : _position;
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

    // The place that is due at an instant.
    public void MoveTo(TimeSpan position, long instant)
    {
        _position = position;
        _reached = position;
        _anchor = instant;
        _shift = Math.Max(0, _newest - instant);
    }

    // Not paced, recorded time and real time go equally fast.
    public long DueAt(TimeSpan time) =>
        _anchor + (long)Math.Round((time - _position).TotalSeconds / (IsPaced ? Speed : 1) * Stopwatch.Frequency);

    // What came by is due at its time, or was and is late. Returns its timestamp: timestamps never go back, and after a time without pace, which
    // is ahead of the real one, they stay ahead.
    public long Reach(TimeSpan time, long now)
    {
        if (IsPaced && now - DueAt(time) > MostBehind)
            MoveTo(time, now);

        _reached = time;
        _newest = Math.Max(_newest, DueAt(time) + _shift);
        return _newest;
    }
}
