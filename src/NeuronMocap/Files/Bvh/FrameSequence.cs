using System.Diagnostics;
using NeuronMocap.Frames;

namespace NeuronMocap.Bvh;

// Determines how many rows to write for a frame, from its index, and the duration of a row, from the receive times.
internal sealed class FrameSequence(BvhGapHandling gaps)
{
    // No suit is faster. An index jump without elapsed time is therefore not a loss, and a malicious stream cannot inflate the file.
    private const int MaxRowsPerSecond = 1000;

    // A longer silence between two frames without an index is a pause of the server.
    private static readonly long LongestInterval = Stopwatch.Frequency;

    // The first frames of a connection or of a starting server often arrive together. Their receive times say nothing about the frame time.
    private static readonly long Settling = Stopwatch.Frequency / 4;
    private static readonly long LongEnough = Stopwatch.Frequency;

    private readonly IndexTracker _tracker = new();

    // The smallest step so far. The tracker knows its step only after 16 frames, and written rows cannot be taken back.
    private uint _step = uint.MaxValue;
    private long _timestamp;
    private long _elapsed;
    private long _intervals;
    private bool _hasBegun;

    // The time of the current connection, and the sums over all connections, each without its first frames.
    private long _run;
    private long _settledElapsed;
    private long _settledIntervals;

    /// <summary>Starts a new sequence. The next frame has no relation in time to the frames before it.</summary>
    public void Restart() => _hasBegun = false;

    /// <summary>Processes the next frame.</summary>
    /// <returns>The number of rows: 0 for a frame that is out of order, 1, or more if frames before it were lost.</returns>
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

    /// <summary>
    /// Computes the time of a row: the nearest usual frame time if it is close to the measured time, otherwise the measured time.
    /// </summary>
    public BvhFrameTime Measure()
    {
        if (_intervals == 0 || _elapsed <= 0)
            return BvhFrameTime.Default;

        (long ticks, long intervals) = _settledElapsed >= LongEnough ? (_settledElapsed, _settledIntervals) : (_elapsed, _intervals);
        double elapsed = (double)ticks / Stopwatch.Frequency;
        double rate = intervals / elapsed;

        // Clocks of suits are off by less than one per cent. The first and the last frame may each be up to 30 ms early or late.
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

    // When the frame rate is reduced, every index is a multiple of the step. The smallest step is therefore the step of consecutive frames.
    private int Advance(uint step, long timestamp)
    {
        _step = Math.Min(_step, step);
        long missing = ((step + (_step / 2)) / _step) - 1;
        bool isLoss = missing * Stopwatch.Frequency <= (timestamp - _timestamp) * MaxRowsPerSecond;
        return isLoss ? Continue(timestamp, (int)missing, isGap: false) : Begin(timestamp);
    }

    // The frames before have no relation in time to the frames that follow.
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
