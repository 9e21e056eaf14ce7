using System.Collections.Immutable;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>A part of the time of a take, in microseconds since its start.</summary>
internal readonly record struct TimeStretch(long From, long To);

/// <summary>
/// The times of a performer's frames: the first of each block of frames, the gaps, and when the frames of a block arrived. One thread adds, any thread reads.
/// </summary>
internal sealed class TakeTimes
{
    /// <summary>Number of frames in a block.</summary>
    public const int BlockSize = 32;

    /// <summary>The shortest time without a frame that is a gap, in seconds. It is longer at low rates.</summary>
    public const double ShortestGap = 0.25;

    private const double FramesInGap = 5;
    private const double Microseconds = 1e6;
    private const double Smoothing = 0.1;
    private const int MostGaps = 10_000;

    private readonly Lock _lock = new();
    private readonly List<long> _blocks = [];
    private readonly List<BlockArrival> _arrivals = [];
    private readonly List<TimeStretch> _gaps = [];
    private double _usualStep = double.NaN;
    private long _count;

    /// <summary>Time of the first frame.</summary>
    public long Start { get; private set; }

    /// <summary>Time of the last frame that was added.</summary>
    public long End { get; private set; }

    /// <summary>Adds the time of the next frame.</summary>
    /// <param name="microseconds">When it was sent, as far as that is known.</param>
    /// <param name="arrival">When it arrived, not before the frame added last.</param>
    /// <returns>Whether a gap precedes the frame.</returns>
    public bool Add(long microseconds, long arrival)
    {
        lock (_lock)
        {
            bool isGap = false;
            if (_count == 0)
                Start = microseconds;
            else
                isGap = AddStep(microseconds);

            if (_count % BlockSize == 0)
            {
                _blocks.Add(microseconds);
                _arrivals.Add(new BlockArrival(arrival, 0));
            }

            BlockArrival block = _arrivals[^1];
            _arrivals[^1] = block with { LongestDelay = Math.Max(block.LongestDelay, arrival - microseconds) };
            End = microseconds;
            _count++;
            return isGap;
        }
    }

    /// <summary>Gets the times without frames.</summary>
    public ImmutableArray<TimeStretch> GetGaps()
    {
        lock (_lock)
            return [.. _gaps];
    }

    /// <summary>Gets the time of the first frame of every <paramref name="step"/>th block.</summary>
    public long[] GetBlockTimes(int step = 1)
    {
        lock (_lock)
        {
            long[] times = new long[(_blocks.Count + step - 1) / step];
            for (int i = 0; i < times.Length; i++)
                times[i] = _blocks[i * step];

            return times;
        }
    }

    /// <summary>Finds the last block that begins at or before a time; the first block if there is none.</summary>
    public int FindBlock(long microseconds)
    {
        lock (_lock)
        {
            int place = _blocks.BinarySearch(microseconds);
            return Math.Max(0, place >= 0 ? place : ~place - 1);
        }
    }

    /// <summary>Finds when the frames of a part had arrived. Where frames were late, it can be the arrival of some more before and after the part.</summary>
    /// <param name="from">Time of the first frame.</param>
    /// <param name="to">Time after the last frame.</param>
    public TimeStretch FindArrival(long from, long to)
    {
        lock (_lock)
            return _count == 0 ? new TimeStretch(from, to) : new TimeStretch(Math.Max(from, _arrivals[FindBlock(from)].First), FindArrivalBefore(to));
    }

    private long FindArrivalBefore(long microseconds)
    {
        int block = FindBlock(microseconds);
        long delay = _arrivals[block].LongestDelay;

        // A shorter delay does not bring a frame beyond the next one.
        if (!(delay > _usualStep * Microseconds) || microseconds <= Start)
            return microseconds;

        // More than the arrival of the last frame, because the end is not a part of a stretch, and the page rounds times to a microsecond.
        long next = block + 1 < _arrivals.Count ? _arrivals[block + 1].First : long.MaxValue - 2;
        return Math.Max(microseconds, Math.Min(microseconds + delay, next) + 2);
    }

    private bool AddStep(long microseconds)
    {
        double step = (microseconds - End) / Microseconds;
        bool isGap = step > ShortestGap && !(step < FramesInGap * _usualStep) && _count > 1;
        if (!isGap)
            _usualStep = double.IsNaN(_usualStep) ? step : _usualStep + (Smoothing * (step - _usualStep));
        else if (_gaps.Count < MostGaps)
            _gaps.Add(new TimeStretch(End, microseconds));

        return isGap;
    }

    /// <summary>When the frames of a block arrived.</summary>
    /// <param name="First">Arrival of the first frame.</param>
    /// <param name="LongestDelay">The longest time from when a frame was sent to its arrival.</param>
    private readonly record struct BlockArrival(long First, long LongestDelay);
}
