namespace NeuronMocap.Timing;

// Finds the rate of times that a program computed, for example for a file: they lie on an even grid to the last tick. Arrival times never do.
internal sealed class EvenGrid
{
    private const int MaxDecimals = 6;

    private (long Place, long Ticks) _first;
    private int _count;
    private bool _isBroken;

    // The range of intervals in ticks that fits all times so far. Each time is rounded to a tick.
    private decimal _shortest;
    private decimal _longest = decimal.MaxValue;

    // The time between two frames is not known.
    public void Break() => _isBroken |= _count > 0;

    // The place must be higher than that of the last frame.
    public void Add(long place, long ticks)
    {
        if (_isBroken)
            return;
        if (_count++ == 0)
        {
            _first = (place, ticks);
            return;
        }

        decimal frames = place - _first.Place;
        _shortest = Math.Max(_shortest, (ticks - _first.Ticks - 1) / frames);
        _longest = Math.Min(_longest, (ticks - _first.Ticks + 1) / frames);
        _isBroken = _shortest > _longest;
    }

    /// <summary>Finds the rate.</summary>
    /// <param name="step">Distance of two frames in places.</param>
    /// <returns>Frames per second; null if the times are not even.</returns>
    public double? FindRate(int step)
    {
        if (_isBroken || _count < 2 || _shortest <= 0)
            return null;

        (decimal lowest, decimal highest) = (TimeSpan.TicksPerSecond / (_longest * step), TimeSpan.TicksPerSecond / (_shortest * step));
        if (FindUsual(lowest, highest) is { } usual)
            return usual;

        // Two frames lie on a grid of some rate, whatever their times are.
        return _count > 2 ? FindSimplest(lowest, highest) : null;
    }

    private static double? FindUsual(decimal lowest, decimal highest)
    {
        foreach (short rate in UsualRates.Common)
        {
            if (rate >= lowest && rate <= highest)
                return rate;
        }

        foreach (short rate in UsualRates.Rare)
        {
            if (rate >= lowest && rate <= highest)
                return rate;
        }

        foreach (short rate in UsualRates.Television)
        {
            if (rate * 1000m / 1001m >= lowest && rate * 1000m / 1001m <= highest)
                return rate * 1000.0 / 1001.0;
        }

        return null;
    }

    private static double FindSimplest(decimal lowest, decimal highest)
    {
        for (int decimals = 0; decimals <= MaxDecimals; decimals++)
        {
            decimal rate = Math.Round((lowest + highest) / 2, decimals);
            if (rate >= lowest && rate <= highest)
                return (double)rate;
        }

        (long numerator, long denominator) = SimplestFraction.Between(lowest, highest);
        return (double)numerator / denominator;
    }
}
