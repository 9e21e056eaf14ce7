using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Determines when a frame is due: frame n at start + n / rate.</summary>
/// <remarks>
/// Each due time is computed from the start, so rounding and late wake-ups do not add up. After a pause longer than a few frames the start moves:
/// the frames of the pause are sent later, not all at once.
/// </remarks>
internal sealed class FrameClock
{
    private const double ToleratedFrames = 4;

    // Some systems wake a thread only every 15.6 ms. At high rates that is many frames, which must not be postponed.
    private const double ToleratedSeconds = 0.02;

    private readonly double _ticksPerFrame;
    private readonly long _tolerance;
    private long _start;

    // Times are ticks of Stopwatch.
    public FrameClock(double rate, long start)
    {
        _ticksPerFrame = Stopwatch.Frequency / rate;
        _tolerance = (long)Math.Max(ToleratedFrames * _ticksPerFrame, ToleratedSeconds * Stopwatch.Frequency);
        _start = start;
    }

    // Milliseconds to wait before the frame may be sent, rounded up; 0 when it is due. A packet between two frames has a number between theirs.
    public int GetDelay(double frame, long now)
    {
        long early = _start + (long)(frame * _ticksPerFrame) - now;
        if (early < -_tolerance)
            _start -= early + _tolerance;

        return early <= 0 ? 0 : (int)Math.Min(int.MaxValue, Math.Ceiling(early * 1000.0 / Stopwatch.Frequency));
    }
}
