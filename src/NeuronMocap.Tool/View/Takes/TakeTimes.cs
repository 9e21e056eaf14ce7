using System.Collections.Immutable;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>A part of the time of a take, in microseconds since its start.</summary>
internal readonly record struct TimeStretch(long From, long To);

/// <summary>The times of a performer's frames: the first of each block of frames, and the gaps. One thread adds, any thread reads.</summary>
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
    private readonly List<TimeStretch> _gaps = [];
    private double _usualStep = double.NaN;
    private long _count;

    /// <summary>Time of the first frame.</summary>
    public long Start { get; private set; }

    /// <summary>Time of the last frame that was added.</summary>
    public long End { get; private set; }

    /// <summary>Adds the time of the next frame.</summary>
    /// <returns>Whether a gap precedes the frame.</returns>
    public bool Add(long microseconds)
    {
        lock (_lock)
        {
            bool isGap = false;
            if (_count == 0)
                Start = microseconds;
            else
                isGap = AddStep(microseconds);

            if (_count % BlockSize == 0)
                _blocks.Add(microseconds);

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
}
