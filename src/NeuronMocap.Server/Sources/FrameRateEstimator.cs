using NeuronMocap.Bvh;

namespace NeuronMocap.Server;

/// <summary>Estimates a frame rate from the times of frames.</summary>
/// <remarks>
/// Arrival times jitter. The result is then the usual rate near the measured one. Times that a program computed from a rate, for example for a file,
/// lie on an even grid to the last tick. The result is then the rate of the grid. Allocates nothing. Not thread-safe.
/// </remarks>
public sealed class FrameRateEstimator
{
    // Two frames lie on every grid.
    private const int MinOnGrid = 3;
    private const int MaxDecimals = 6;
    private const decimal TicksPerSecond = TimeSpan.TicksPerSecond;

    private (long Frame, TimeSpan Time) _first;
    private (long Frame, TimeSpan Time) _last;
    private long _frames;
    private TimeSpan _time;
    private int _count;
    private bool _isBroken;

    // The range of frame durations in ticks that fits all times so far. Each time is rounded to a tick.
    private decimal _shortest;
    private decimal _longest = decimal.MaxValue;

    /// <summary>Measured frames per second, with missing frames counted. Null if the times do not give a rate.</summary>
    public double? MeasuredFrameRate => _time > TimeSpan.Zero ? _frames / _time.TotalSeconds : null;

    /// <summary>Whether at least three frames were added and all of them lie on an even grid, to a tick.</summary>
    public bool IsUniform => !_isBroken && _count >= MinOnGrid && _shortest > 0 && _shortest <= _longest;

    /// <summary>The estimated rate. Null if the times do not give a rate.</summary>
    /// <value>
    /// On an even grid, the rate of the grid. Otherwise a usual rate within one per cent of the measured one, or else the measured rate.
    /// </value>
    public double? FrameRate => IsUniform ? FindEvenRate() : MeasuredFrameRate is { } measured ? RecordingSource.ChooseFrameRate(measured) : null;

    /// <summary>Adds a frame.</summary>
    /// <param name="frame">Number of the frame, with missing frames counted. It must be higher than that of the previous frame.</param>
    /// <param name="time">Arrival time of the frame.</param>
    public void Add(long frame, TimeSpan time)
    {
        if (_count++ == 0)
        {
            _first = _last = (frame, time);
            return;
        }

        _frames += frame - _last.Frame;
        _time += time - _last.Time;
        _last = (frame, time);
        long frames = frame - _first.Frame;
        long ticks = (time - _first.Time).Ticks;
        if (frames <= 0)
        {
            _isBroken = true;
            return;
        }

        _shortest = Math.Max(_shortest, (ticks - 1) / (decimal)frames);
        _longest = Math.Min(_longest, (ticks + 1) / (decimal)frames);
    }

    /// <summary>Adds a frame whose distance from the previous frame is unknown, for example after a new connection.</summary>
    /// <param name="frame">Any number. Later frames continue from it.</param>
    /// <param name="time">Arrival time of the frame.</param>
    public void Restart(long frame, TimeSpan time)
    {
        _isBroken |= _count > 0;
        _count++;
        _last = (frame, time);
        if (_count == 1)
            _first = _last;
    }

    private double FindEvenRate()
    {
        decimal lowest = TicksPerSecond / _longest;
        decimal highest = TicksPerSecond / _shortest;
        foreach (short usual in BvhFrameTimeText.UsualRates)
        {
            if (usual >= lowest && usual <= highest)
                return usual;
        }

        foreach (short usual in BvhFrameTimeText.TelevisionRates)
        {
            decimal rate = usual * 1000m / 1001m;
            if (rate >= lowest && rate <= highest)
                return usual * 1000.0 / 1001.0;
        }

        for (int decimals = 0; decimals <= MaxDecimals; decimals++)
        {
            decimal rate = Math.Round((lowest + highest) / 2, decimals);
            if (rate >= lowest && rate <= highest)
                return (double)rate;
        }

        (long numerator, long denominator) = BvhFrameTime.SimplestFraction(lowest, highest);
        return (double)numerator / denominator;
    }
}
