using System.Diagnostics;

namespace NeuronMocap.Delivery;

// Measures the time between two indices of a stream by the arrival of its frames. Receive thread only.
internal sealed class MeanInterval
{
    // Weight of a new interval in the mean: about two seconds at 120 Hz.
    private const int MeanLength = 256;

    // An interval that is so many times as long as the mean begins a burst: the network held frames back, which follow at once. Or the server paused.
    private const int BurstFactor = 4;

    // When two blocks in a row disagree with the mean in the same direction, the server has changed its rate. A block that takes almost no time is a
    // backlog: the server sent it at once when the connection began.
    private const int BlockLength = 16;
    private const double BacklogRatio = 0.05;
    private const double FasterRatio = 2.0 / 3;
    private const double SlowerRatio = 1.5;

    // Arrivals that vary by up to this part of an interval change the mean of n intervals by at most an n-th of it.
    private const double LargestJitter = 0.45;

    // Longer intervals are never measured.
    private static readonly long LongestInterval = Stopwatch.Frequency;

    private long _lastTimestamp;
    private bool _hasLast;
    private bool _isNewConnection;
    private int _intervals;
    private double _meanTicks;
    private double _meanSteps;
    private int _burstFrames;
    private double _burstTicks;
    private double _burstSteps;
    private bool _wasRefused;
    private int _blockFrames;
    private double _blockTicks;
    private double _blockSteps;
    private int _lastDirection;

    // Null before the first interval.
    public double? Ticks => _intervals > 0 ? _meanTicks / _meanSteps : null;

    // The part of itself by which the mean may still be wrong. Almost nothing when the mean is complete.
    public double Uncertainty => _intervals is > 0 and < MeanLength ? LargestJitter / _intervals : 0;

    // The next frame belongs to another connection. The time until then says nothing about the server's rate.
    public void Restart()
    {
        _isNewConnection = true;
        _burstFrames = 0;
        _wasRefused = false;
        EndBlock(direction: 0);
    }

    // Returns the time since the last frame. isPause: the index says nothing about this time.
    public long Add(uint step, long timestamp, out bool isPause)
    {
        long ticks = _hasLast ? Math.Max(timestamp - _lastTimestamp, 0) : 0;
        isPause = !_hasLast || _isNewConnection || ticks > LongestInterval;
        if (_hasLast && !_isNewConnection)
            Collect(step, ticks);

        _lastTimestamp = Math.Max(timestamp, _lastTimestamp);
        _hasLast = true;
        _isNewConnection = false;
        return ticks;
    }

    private void Collect(uint step, long ticks)
    {
        if (_burstFrames > 0 && !(ticks > ExpectedTicks(step) / 2))
        {
            AddToBurst(step, ticks);
            return;
        }

        EndBurst();
        if (ticks > BurstFactor * ExpectedTicks(step))
        {
            AddToBurst(step, ticks);
            return;
        }

        _wasRefused = false;
        Measure(step, ticks);
    }

    private double ExpectedTicks(uint step) => Ticks is { } mean ? mean * step : double.PositiveInfinity;

    private void AddToBurst(uint step, long ticks)
    {
        _burstFrames++;
        _burstTicks += ticks;
        _burstSteps += step;
    }

    // A burst as a whole takes the time of its frames. If it takes longer, it was a pause and is left out. If the next one takes longer as well, with no
    // other frame in between, the mean is wrong.
    private void EndBurst()
    {
        if (_burstFrames == 0)
            return;

        double ticks = _burstTicks / _burstFrames;
        double steps = _burstSteps / _burstFrames;
        double ratio = ticks / (steps * Ticks!.Value);
        bool fits = ratio is > FasterRatio and < SlowerRatio;
        int frames = fits || _wasRefused ? Math.Min(_burstFrames, MeanLength) : 0;
        (_burstFrames, _burstTicks, _burstSteps, _wasRefused) = (0, 0, 0, !fits);
        for (int i = 0; i < frames; i++)
            Measure(steps, ticks);
    }

    private void Measure(double steps, double ticks)
    {
        if (ticks > LongestInterval)
            return;

        double weight = 1.0 / (_intervals < MeanLength ? ++_intervals : MeanLength);
        _meanTicks += weight * (ticks - _meanTicks);
        _meanSteps += weight * (steps - _meanSteps);

        _blockTicks += ticks;
        _blockSteps += steps;
        if (++_blockFrames < BlockLength)
            return;

        double ratio = _blockTicks / (_blockSteps * Ticks!.Value);
        int direction = ratio > SlowerRatio ? 1 : ratio is > BacklogRatio and < FasterRatio ? -1 : 0;
        if (direction != 0 && direction == _lastDirection)
        {
            (_intervals, _meanTicks, _meanSteps) = (BlockLength, _blockTicks / BlockLength, _blockSteps / BlockLength);
            direction = 0;
        }

        EndBlock(direction);
    }

    private void EndBlock(int direction) => (_blockFrames, _blockTicks, _blockSteps, _lastDirection) = (0, 0, 0, direction);
}
