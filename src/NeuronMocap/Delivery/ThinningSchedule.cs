using System.Diagnostics;

namespace NeuronMocap.Delivery;

// Decides which frames of one kind and one avatar are taken. Each frame adds its share of the interval between two taken frames to a carry, and the frame
// that fills the carry is taken. The rest stays in the carry, so the taken frames are spread as evenly as the ratio of the two rates permits.
//
// A frame's share follows from its index and from the mean interval of the stream, not from the time of its arrival. Frames that arrive in bursts are
// thinned like any others. Receive thread only.
internal sealed class ThinningSchedule(FrameThinning thinning)
{
    // Verdicts are kept for this many indices before the newest. UDP can swap neighbouring frames, and one kind can lag behind another.
    private const int Window = 63;
    private const uint LargestStep = 10_000;
    private const int RestartRun = 3;

    // Weight of a new interval in the mean: about two seconds at 120 Hz. Bursts of ten frames then change the mean by less than Tolerance.
    private const int MeanLength = 256;

    // Within this part of a whole fraction, the ratio of the rates counts as the fraction. The measured rate always varies a little; without the tolerance
    // 120 Hz thinned to 60 Hz would sometimes take two frames in a row.
    private const double Tolerance = 0.02;

    // A kind that gets none of its frames for this many intervals does not share its indices with the other kind.
    private const double Starved = 3;

    // The carry is a sum of fractions that may not add up to 1 exactly.
    private const double Rounding = 1e-6;

    // A longer interval is a pause or a slow stream: the carry then follows the time itself.
    private static readonly long LongestInterval = Stopwatch.Frequency;

    private readonly double _intervalWanted = thinning.MaxRate > 0 ? Stopwatch.Frequency / thinning.MaxRate : 0;
    private uint? _newest;
    private ulong _decided; // Bit n: the frame n before the newest has a verdict.
    private ulong _taken;
    private int _lateRun;
    private long _lastTimestamp;
    private bool _hasLast;
    private int _intervals;
    private double _meanTicks;
    private double _meanSteps;
    private double _carry = 1;

    // Whether the verdicts of other kinds do not suit this kind: a server can send it at another rate.
    public bool IsAlone { get; private set; }

    // The verdict on a recent index; null if there is none.
    public bool? FindVerdict(uint index)
    {
        if (_newest is not { } newest || newest - index > Window)
            return null;

        ulong bit = 1UL << (int)(newest - index);
        return (_decided & bit) == 0 ? null : (_taken & bit) != 0;
    }

    // For a frame without an index.
    public bool Decide(long timestamp)
    {
        _newest = null;
        return Advance(1, timestamp);
    }

    public bool Decide(uint index, long timestamp)
    {
        if (IsLate(index))
            return FindVerdict(index) ?? false;

        bool isTaken = Advance(MoveTo(index), timestamp);
        Note(isTaken);
        return isTaken;
    }

    // Another kind of the same avatar has decided this index. Its carry is copied too, so this schedule can continue without the other.
    public bool Follow(ThinningSchedule other, uint index, long timestamp, bool isTaken)
    {
        if (IsLate(index))
            return isTaken;

        uint step = MoveTo(index);
        long ticks = Measure(step, timestamp);
        _carry += Math.Min(FindShare(step, ticks), 1);
        IsAlone = !isTaken && _carry >= Starved;
        if (IsAlone || isTaken)
            _carry = IsAlone ? 0 : other._carry;

        Note(isTaken || IsAlone);
        return isTaken || IsAlone;
    }

    public void Restart()
    {
        _newest = null;
        _decided = 0;
        _taken = 0;
        _lateRun = 0;
        IsAlone = false;
    }

    // A server that repeats its index, or counts backwards, restarts its count with the third such frame.
    private bool IsLate(uint index)
    {
        if (_newest is not { } newest || newest - index - 1 >= Window)
        {
            _lateRun = 0;
            return false;
        }

        if (++_lateRun < RestartRun)
            return true;

        Restart();
        return false;
    }

    // Returns the step of the index from the last frame to this one; 1 if the count began again.
    private uint MoveTo(uint index)
    {
        uint step = _newest is { } newest ? index - newest : 0;
        _newest = index;
        bool isContinued = step is > 0 and <= LargestStep;
        _decided = isContinued && step <= Window ? _decided << (int)step : 0;
        _taken = isContinued && step <= Window ? _taken << (int)step : 0;
        return isContinued ? step : 1;
    }

    private void Note(bool isTaken)
    {
        _decided |= 1;
        _taken |= isTaken ? 1UL : 0;
    }

    private bool Advance(uint step, long timestamp)
    {
        long ticks = Measure(step, timestamp);
        double share = FindShare(step, ticks);
        _carry += share;
        if (_carry < 1 - Rounding)
            return false;

        // After a gap, more than one frame's share is left. It must not be made up for, because the frames would then follow each other closely.
        _carry -= 1;
        if (_carry >= Math.Min(share, 1) - Rounding)
            _carry = 0;
        return true;
    }

    private double FindShare(uint step, long ticks)
    {
        if (_intervalWanted == 0)
            return 1.0 / thinning.EveryNth;
        if (ticks > LongestInterval || _intervals == 0)
            return ticks / _intervalWanted;

        double interval = _meanTicks / _meanSteps;
        double ratio = _intervalWanted / interval;
        double whole = Math.Max(Math.Round(ratio), 1);
        double share = Math.Abs(ratio - whole) <= whole * Tolerance ? 1 / whole : 1 / ratio;
        return share * step;
    }

    // Returns the time since the last frame.
    private long Measure(uint step, long timestamp)
    {
        long ticks = _hasLast ? Math.Max(timestamp - _lastTimestamp, 0) : 0;
        if (_hasLast && ticks <= LongestInterval)
        {
            double weight = 1.0 / (_intervals < MeanLength ? ++_intervals : MeanLength);
            _meanTicks += weight * (ticks - _meanTicks);
            _meanSteps += weight * (step - _meanSteps);
        }

        _lastTimestamp = Math.Max(timestamp, _lastTimestamp);
        _hasLast = true;
        return ticks;
    }
}
