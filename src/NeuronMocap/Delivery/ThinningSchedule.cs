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

    // Within this part of a whole fraction, the ratio of the rates counts as the fraction. The measured rate always varies a little; without the tolerance
    // 120 Hz thinned to 60 Hz would sometimes take two frames in a row.
    private const double Tolerance = 0.02;

    // A kind that gets none of its frames for this many intervals, although none was lost, does not share its indices with the other kind.
    private const double Starved = 3;

    // The carry is a sum of fractions that may not add up to 1 exactly.
    private const double Rounding = 1e-6;

    private readonly double _intervalWanted = thinning.MaxRate > 0 ? Stopwatch.Frequency / thinning.MaxRate : 0;
    private readonly MeanInterval _mean = new();
    private readonly IndexGrid _grid = new();
    private uint? _newest;
    private ulong _decided; // Bit n: the frame n before the newest has a verdict.
    private ulong _taken;
    private int _lateRun;
    private double _carry = 1;
    private double _starvation;

    // Whether the verdicts of other kinds do not suit this kind: a server can send it at another rate.
    public bool IsAlone { get; private set; }

    public bool HasVerdicts => _newest is not null;

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
        return Advance(1, 1, timestamp);
    }

    // other: another kind of the same avatar, or null. Its verdicts between the last frame of this kind and this one count.
    public bool Decide(uint index, long timestamp, ThinningSchedule? other = null)
    {
        if (IsLate(index))
        {
            bool isLateTaken = FindVerdict(index) ?? false;
            NoteLate(index, isLateTaken);
            return isLateTaken;
        }

        uint? last = _newest;
        uint step = MoveTo(index);
        uint undecided = step;
        if (other?._newest is { } ahead && last is { } newest && ahead - newest - 1 < Window && index - ahead - 1 < Window)
        {
            undecided = index - ahead;
            _carry = other._carry;
        }

        bool isTaken = Advance(step, undecided, timestamp);
        Note(isTaken);
        return isTaken;
    }

    // Another kind of the same avatar has decided this index. Its carry is copied, so this schedule can continue without the other.
    public bool Follow(ThinningSchedule other, uint index, long timestamp, bool isTaken)
    {
        if (IsLate(index))
        {
            NoteLate(index, isTaken);
            return isTaken;
        }

        uint? last = _newest;
        uint step = MoveTo(index);
        double share = FindShare(step, _mean.Add(step, timestamp, out bool isPause), isPause);
        bool isShared = isTaken || HasLost(other, last, index);
        _starvation = isShared ? 0 : _starvation + Math.Min(share, 1);
        IsAlone = _starvation >= Starved;
        if (IsAlone)
            _carry = 0;
        else if (isTaken || other._newest == index)
            _carry = other._carry;
        else
            _carry += Math.Min(share, 1);

        Note(isTaken || IsAlone);
        return isTaken || IsAlone;
    }

    // The next frame belongs to another connection.
    public void Restart()
    {
        RestartIndex();
        _mean.Restart();
    }

    private void RestartIndex()
    {
        _newest = null;
        _decided = 0;
        _taken = 0;
        _lateRun = 0;
        _starvation = 0;
        _grid.Reset();
        IsAlone = false;
    }

    // Whether frames of this kind were lost that the other kind took. This kind would have got them.
    private bool HasLost(ThinningSchedule other, uint? last, uint index)
    {
        uint grid = _grid.Step;
        for (uint missing = index - grid; last is { } newest && index - missing < index - newest && index - missing <= Window; missing -= grid)
        {
            if (other.FindVerdict(missing) is true)
                return true;
        }

        return false;
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

        RestartIndex();
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
        if (isContinued)
            _grid.Add(step);

        return isContinued ? step : 1;
    }

    private void Note(bool isTaken)
    {
        _decided |= 1;
        _taken |= isTaken ? 1UL : 0;
    }

    // The partner of a late frame can still arrive.
    private void NoteLate(uint index, bool isTaken)
    {
        ulong bit = 1UL << (int)(_newest!.Value - index);
        _decided |= bit;
        _taken |= isTaken ? bit : 0;
    }

    // undecided: the part of the step that has no verdict of any kind yet.
    private bool Advance(uint step, uint undecided, long timestamp)
    {
        double share = FindShare(undecided, _mean.Add(step, timestamp, out bool isPause), isPause);
        _carry += share;
        if (_carry < 1 - Rounding)
            return false;

        // After a gap, more than one frame's share is left. It must not be made up for, because the frames would then follow each other closely.
        _carry -= 1;
        if (_carry >= Math.Min(share, 1) - Rounding)
            _carry = 0;
        _starvation = 0;
        return true;
    }

    // After a pause, the carry follows the time itself.
    private double FindShare(uint step, long ticks, bool isPause)
    {
        if (_intervalWanted == 0)
            return 1.0 / thinning.EveryNth;
        if (isPause || _mean.Ticks is not { } interval)
            return ticks / _intervalWanted;

        // A new stream may have the wanted rate itself. It then gets every frame, also while its mean is not known well.
        if (Math.Abs(interval - _intervalWanted) <= (Tolerance + _mean.Uncertainty) * _intervalWanted)
            return step;

        double ratio = _intervalWanted / interval;
        double whole = Math.Max(Math.Round(ratio), 1);
        double share = Math.Abs(ratio - whole) <= whole * Tolerance ? 1 / whole : 1 / ratio;
        return share * step;
    }
}
