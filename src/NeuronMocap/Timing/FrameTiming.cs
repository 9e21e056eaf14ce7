using NeuronMocap.Frames;

namespace NeuronMocap.Timing;

// Determines which frames of an avatar are missing, and how many the server sends in a second. Frame indices and arrival times are all it knows.
// Everything that writes or plays frames at an even rate uses it, so the same frames have the same rate everywhere. Adding a frame allocates nothing,
// apart from a list that grows by one result in half a second. Not thread-safe.
internal sealed class FrameTiming
{
    // No suit is faster. If the index jumps but no time has passed, no frames are missing, and a malicious stream cannot inflate a file.
    private const int HighestRate = 1000; // Hz

    // A larger step is a gap, not a reduced frequency.
    private const uint LargestStep = 60;

    // The range of a BVH file.
    private const double LowestRate = 1 / 3600.0;
    private const double RateLimit = 1e6;

    private readonly IndexTracker _tracker = new();
    private readonly FrameInterval _interval = new();
    private readonly EvenGrid _grid = new();
    private int? _connection;
    private uint? _step;
    private TimeSpan _time;

    // Counts in steps of the index, so it stays right if the step turns out to be smaller.
    private long _place;

    /// <summary>
    /// Difference between the indices of two consecutive frames: more than 1 if the server sends only every second or third frame.
    /// </summary>
    /// <remarks>It is the smallest difference so far. A server that reduces its frequency sends only multiples of it.</remarks>
    public int Step => (int)(_step ?? 1);

    /// <summary>Frames per second by the arrival times, with missing frames counted. Null if the times do not give a rate.</summary>
    public double? MeasuredRate => _interval.Measure() is { Ticks: > 0 } sum ? RateOf(sum) : null;

    /// <summary>Frames per second, as the server is probably set. Null if the times do not give a rate.</summary>
    /// <value>
    /// If the times are even to the tick, their rate. Otherwise the usual rate nearest to the measured one, or else the measured rate to a hundredth.
    /// </value>
    public double? Rate => (_grid.FindRate(Step) ?? FindUsualRate()) is { } rate ? Math.Clamp(rate, LowestRate, RateLimit) : null;

    /// <summary>Adds the next frame.</summary>
    /// <param name="index">Its index; null if it has none.</param>
    /// <param name="time">Its arrival time.</param>
    /// <param name="connection">Number of its connection. The time between two connections says nothing.</param>
    /// <returns>
    /// The distance from the previous frame, in frames. It is 1 if no frame is missing or the distance is unknown, and 0 for a frame that
    /// came after a later one.
    /// </returns>
    public int Add(uint? index, TimeSpan time, int connection)
    {
        if (connection != _connection)
        {
            _connection = connection;
            _tracker.StartAt(index);
            return Restart(time);
        }

        uint? last = _tracker.Newest;
        switch (_tracker.OnIndex(index))
        {
            case IndexChange.Late:
                return 0;
            case IndexChange.Restart:
                return Restart(time);
            case IndexChange.Ahead:
                return Advance(index!.Value - last!.Value, time);
            case IndexChange.Same when _step is not null:
                // The server counts, and sent this frame again.
                return 1;
            default:
                Continue(1, time);
                return 1;
        }
    }

    /// <summary>Gets the distance of two frames, in frames.</summary>
    /// <returns>1 if the frames have no indices. Null if the index does not give the distance.</returns>
    public long? FramesBetween(uint? before, uint? after)
    {
        if (before is null || after is null)
            return 1;

        int difference = (int)(after.Value - before.Value);
        return difference > 0 && difference % Step == 0 ? difference / Step : null;
    }

    private int Advance(uint difference, TimeSpan time)
    {
        if (difference <= LargestStep)
            _step = Math.Min(_step ?? difference, difference);

        int frames = (int)(difference + ((uint)Step / 2)) / Step;
        if (frames - 1 > (time - _time).TotalSeconds * HighestRate)
            return Restart(time);

        Continue(difference, time);
        return frames;
    }

    private int Restart(TimeSpan time)
    {
        (_place, _time) = (_place + 1, time);
        _interval.Restart(_place, time.Ticks);
        _grid.Break();
        _grid.Add(_place, time.Ticks);
        return 1;
    }

    private void Continue(uint difference, TimeSpan time)
    {
        (_place, _time) = (_place + difference, time);
        _interval.Add(_place, time.Ticks);
        _grid.Add(_place, time.Ticks);
    }

    private double? FindUsualRate()
    {
        if (_interval.Measure() is not { Ticks: > 0 } sum)
            return null;

        double measured = RateOf(sum);
        return UsualRates.FindNearest(measured, (double)sum.Ticks / TimeSpan.TicksPerSecond) ?? (measured >= 1 ? Math.Round(measured, 2) : measured);
    }

    private double RateOf((long Frames, long Ticks) sum) => (double)sum.Frames * TimeSpan.TicksPerSecond / ((double)sum.Ticks * Step);
}
