using NeuronMocap.Bvh;

namespace NeuronMocap.Server;

/// <summary>
/// The rate behind the times of frames. Times of arrival jitter, and then the usual rate near the measured one is meant. Times that a program made of a
/// rate, as of a file, stand on an even grid to the last tick, and then their rate is kept as it is. Allocates nothing. Not thread-safe.
/// </summary>
public sealed class FrameRateEstimator
{
    // Two frames stand on every grid.
    private const int MinOnGrid = 3;
    private const int MaxDecimals = 6;
    private const decimal TicksPerSecond = TimeSpan.TicksPerSecond;

    private (long Frame, TimeSpan Time) _first;
    private (long Frame, TimeSpan Time) _last;
    private long _frames;
    private TimeSpan _time;
    private int _count;
    private bool _isBroken;

    // Ticks of a frame that all times so far allow; each of them is rounded to a tick.
    private decimal _shortest;
    private decimal _longest = decimal.MaxValue;

    /// <summary>Frames per second by the times, missing frames counted; null where they do not tell.</summary>
    public double? MeasuredFrameRate => _time > TimeSpan.Zero ? _frames / _time.TotalSeconds : null;

    /// <summary>Whether every frame stands where an even rate puts it, to a tick; three frames at least.</summary>
    public bool IsUniform => !_isBroken && _count >= MinOnGrid && _shortest > 0 && _shortest <= _longest;

    /// <summary>The rate that is meant: of an even grid its own; else a usual one within one per cent of the measured one, or that one. Null where nothing tells.</summary>
    public double? FrameRate => IsUniform ? FindEvenRate() : MeasuredFrameRate is { } measured ? RecordingSource.ChooseFrameRate(measured) : null;

    /// <summary>Takes a frame.</summary>
    /// <param name="frame">Its number, missing ones counted; higher than that of the one before.</param>
    /// <param name="time">When it came.</param>
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

    /// <summary>Takes a frame whose distance from the one before is not known, as behind a new connection.</summary>
    /// <param name="frame">Any number that later ones go on from.</param>
    /// <param name="time">When it came.</param>
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
