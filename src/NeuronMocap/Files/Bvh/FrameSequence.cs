using System.Diagnostics;
using NeuronMocap.Frames;

namespace NeuronMocap.Bvh;

// How many rows a frame makes, by its index, and how long a row lasts, by the times of receipt.
internal sealed class FrameSequence(BvhGapHandling gaps)
{
    // No suit is faster. An index that jumps without time having passed is no loss, and a stream that means harm cannot blow up the file.
    private const int MaxRowsPerSecond = 1000;

    // A longer silence between two frames without an index is a pause of the server.
    private static readonly long LongestInterval = Stopwatch.Frequency;

    // The first frames of a connection, and of a server that starts, often come in one piece, and say nothing about the time between them.
    private static readonly long Settling = Stopwatch.Frequency / 4;
    private static readonly long LongEnough = Stopwatch.Frequency;

    private readonly IndexTracker _tracker = new();

    // The smallest so far. The tracker's is known after 16 frames, and rows that were written cannot be taken back.
    private uint _step = uint.MaxValue;
    private long _timestamp;
    private long _elapsed;
    private long _intervals;
    private bool _hasBegun;

    // Of the connection that stands; and the sums of all, each without its first frames.
    private long _run;
    private long _settledElapsed;
    private long _settledIntervals;

    /// <summary>What comes next counts anew, and its time has no relation to what came before.</summary>
    public void Restart() => _hasBegun = false;

    /// <summary>Takes the next frame.</summary>
    /// <returns>The number of rows: none for a frame that comes late, one, or more where others were lost before it.</returns>
    public int Next(uint? index, long timestamp)
    {
        if (!_hasBegun)
        {
            _tracker.StartAt(index);
            return Begin(timestamp);
        }

        uint? last = _tracker.Newest;
        return _tracker.OnIndex(index) switch
        {
            IndexChange.None => Continue(timestamp, missing: 0, isGap: timestamp - _timestamp > LongestInterval),
            IndexChange.Same => Continue(timestamp, missing: 0, isGap: false),
            IndexChange.Late => 0,
            IndexChange.Restart => Begin(timestamp),
            _ => Advance(index!.Value - last!.Value, timestamp),
        };
    }

    /// <summary>The time of a row: the usual one that is near what was measured, else the measured one.</summary>
    public BvhFrameTime Measure()
    {
        if (_intervals == 0 || _elapsed <= 0)
            return BvhFrameTime.Default;

        (long ticks, long intervals) = _settledElapsed >= LongEnough ? (_settledElapsed, _settledIntervals) : (_elapsed, _intervals);
        double elapsed = (double)ticks / Stopwatch.Frequency;
        double rate = intervals / elapsed;

        // Clocks of suits are off by less than a hundredth; the first and the last frame each come by up to 30 ms early or late.
        double tolerance = 0.015 + (0.06 / elapsed);
        double? nearest = null;
        foreach (short usual in BvhFrameTimeText.UsualRates)
        {
            double distance = Math.Abs((usual / rate) - 1);
            if (distance > tolerance)
                continue;

            tolerance = distance;
            nearest = usual;
        }

        return BvhFrameTime.FromFrameRate(nearest ?? Math.Min(Math.Max(Math.Round(rate, 2), 0.01), 1e6));
    }

    // Of frequency reducing every index is a multiple: the smallest step is from one frame to the next.
    private int Advance(uint step, long timestamp)
    {
        _step = Math.Min(_step, step);
        long missing = ((step + (_step / 2)) / _step) - 1;
        bool isLoss = missing * Stopwatch.Frequency <= (timestamp - _timestamp) * MaxRowsPerSecond;
        return isLoss ? Continue(timestamp, (int)missing, isGap: false) : Begin(timestamp);
    }

    // What came before has no relation in time to what comes now.
    private int Begin(long timestamp)
    {
        _run = 0;
        (_timestamp, _hasBegun) = (timestamp, true);
        return 1;
    }

    private int Continue(long timestamp, int missing, bool isGap)
    {
        bool isCounted = !isGap && (missing == 0 || gaps == BvhGapHandling.Repeat);
        if (isCounted)
            Count(timestamp - _timestamp, missing + 1);

        _timestamp = timestamp;
        return gaps == BvhGapHandling.Repeat ? missing + 1 : 1;
    }

    private void Count(long elapsed, int intervals)
    {
        _elapsed += elapsed;
        _intervals += intervals;
        if (_run >= Settling)
        {
            _settledElapsed += elapsed;
            _settledIntervals += intervals;
        }

        _run += elapsed;
    }
}
