namespace NeuronMocap.Timing;

// Measures the usual time from one frame to the next. Each stretch of half a second gives a result, and the result is the mean of those near their
// median. Stretches with a pause of the server, a burst or lost frames without numbers therefore have no influence. The memory is limited: only the
// last stretches count. It grows slowly, because a file can name any number of avatars.
internal sealed class FrameInterval
{
    private const long StretchTicks = TimeSpan.TicksPerSecond / 2;
    private const int MaxStretches = 600; // 5 min
    private const double Similar = 0.02;

    private readonly LowerHull _hull = new();
    private readonly List<(long Frames, long Ticks)> _stretches = [];
    private int _oldest;
    private (long Frames, long Ticks)[] _sorted = [];
    private double[] _intervals = [];

    // The time between this frame and the one before it says nothing.
    public void Restart(long place, long ticks)
    {
        EndStretch();
        _hull.Add(place, ticks);
    }

    public void Add(long place, long ticks)
    {
        _hull.Add(place, ticks);
        if (_hull.ElapsedTicks >= StretchTicks || _hull.IsFull)
            Restart(place, ticks);
    }

    // The frames and their time. The time is 0 if there is no result.
    public (long Frames, long Ticks) Measure()
    {
        int count = Sort();
        double median = FindMedian(count);
        (long Frames, long Ticks) sum = default;
        for (int i = 0; i < count; i++)
        {
            if (Math.Abs((_intervals[i] / median) - 1) <= Similar)
                sum = (sum.Frames + _sorted[i].Frames, sum.Ticks + _sorted[i].Ticks);
        }

        return sum;
    }

    private void EndStretch()
    {
        if (_hull.LongestEdge is { Ticks: > 0 } edge)
            Keep(edge);

        _hull.Clear();
    }

    private void Keep((long Frames, long Ticks) stretch)
    {
        if (_stretches.Count < MaxStretches)
        {
            _stretches.Add(stretch);
            return;
        }

        _stretches[_oldest] = stretch;
        _oldest = (_oldest + 1) % MaxStretches;
    }

    // Sorts the stretches by the time from one frame to the next. Returns their number.
    private int Sort()
    {
        int count = _stretches.Count;
        if (_sorted.Length <= count)
        {
            _sorted = new (long, long)[_stretches.Capacity + 1];
            _intervals = new double[_sorted.Length];
        }

        _stretches.CopyTo(_sorted);
        if (_hull.LongestEdge is { Ticks: > 0 } edge)
            _sorted[count++] = edge;

        for (int i = 0; i < count; i++)
            _intervals[i] = (double)_sorted[i].Ticks / _sorted[i].Frames;

        Array.Sort(_intervals, _sorted, 0, count);
        return count;
    }

    // In half of the time, frames follow each other faster. A pause weighs as much as any other stretch.
    private double FindMedian(int count)
    {
        long all = 0;
        for (int i = 0; i < count; i++)
            all += Math.Min(_sorted[i].Ticks, StretchTicks);

        long passed = 0;
        int median = 0;
        while (median < count && (passed += Math.Min(_sorted[median].Ticks, StretchTicks)) * 2 < all)
            median++;

        return median < count ? _intervals[median] : 0;
    }
}
