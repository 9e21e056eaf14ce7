using System.Runtime.CompilerServices;

namespace NeuronMocap.Frames;

// Follows the frame index of one avatar and classifies each step: the next frame, a gap, a late frame, or a restart of the server's count. A server can
// also send only every second or third frame (Axis Neuron's frequency reduction); the index then steps evenly by 2 or 3. One thread writes, any thread
// reads; each figure is consistent on its own. The index wraps at 2^32, which unsigned differences handle.
internal sealed class IndexTracker
{
    // A server that restarts or switches to another take can start its count anywhere. A larger step than this is therefore not a gap.
    private const uint LargestGap = 10_000;

    // UDP can swap neighbouring frames. A frame within this delay is late, not a restart. The mask of missing frames has one bit for each.
    private const int LargestDelay = 63;

    // The number of late frames in a row that mean a restart of the count, as at the start of a take. They must fill no gap and count up evenly.
    private const int RestartRun = 3;

    // The number of steps in a row that mean a reduced frequency instead of lost frames. The steps must share a divisor above the known step, and most
    // must equal it. If half of all frames are lost at random, this happens once in about two weeks. A regular loss of every second frame looks the same
    // as frequency reduction.
    private const int ReductionRun = 16;

    // With a larger step, two swapped frames would look like a restart.
    private const uint LargestReduction = 60;

    private uint? _newest;
    private ulong _missing; // Bit n: the frame n before the newest counts as lost.
    private int _step = 1;
    private EvenSteps _even;
    private uint _lateIndex;
    private uint _lateStep;
    private int _lateRun;
    private long _lost;
    private long _unsettled;
    private long _gaps;
    private long _outOfOrder;
    private long _restarts;

    public long Lost => Volatile.Read(ref _lost);

    // The number of lost frames that will be subtracted if the next steps are as even as the last ones.
    public long Unsettled => Volatile.Read(ref _unsettled);

    public long Gaps => Volatile.Read(ref _gaps);

    public long OutOfOrder => Volatile.Read(ref _outOfOrder);

    public long Restarts => Volatile.Read(ref _restarts);

    // The step of the index from frame to frame.
    public int Step => Volatile.Read(ref _step);

    // Writing thread only. Null before the first index, and after a frame without an index.
    public uint? Newest => _newest;

    // Forgets the last index but keeps the step, which is a setting of the server. A smaller step shows with the next frame.
    public void StartAt(uint? index)
    {
        _newest = index;
        _missing = 0;
        _lateRun = 0;
        EndRun();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public IndexChange OnIndex(uint? index)
    {
        if (index is not { } next || _newest is not { } newest)
        {
            StartAt(index);
            return IndexChange.None;
        }

        uint step = next - newest;
        uint back = newest - next;
        if (step == (uint)_step)
        {
            Advance(next, step);
            EndRun();
            return IndexChange.Ahead;
        }

        return OnOtherStep(next, step, back);
    }

    // Called if another source says that the count restarts.
    public void Restart()
    {
        Volatile.Write(ref _restarts, _restarts + 1);
        StartAt(null);
    }

    private IndexChange OnOtherStep(uint next, uint step, uint back)
    {
        if (back <= LargestDelay)
            return OnLate(next, (int)back);
        if (step > LargestGap)
            return Restart(next);

        Widen(next, step);
        return IndexChange.Ahead;
    }

    // Handles a larger or smaller step: a gap, or another frequency.
    private void Widen(uint next, uint step)
    {
        Advance(next, step);
        if (step < (uint)_step)
        {
            Volatile.Write(ref _step, (int)step);
            EndRun();
            return;
        }

        uint known = (uint)_step;
        uint lost = (step - 1) / known;
        for (uint back = step - (lost * known); back < step && back <= LargestDelay; back += known)
            _missing |= 1UL << (int)back;

        Volatile.Write(ref _lost, _lost + lost);
        Volatile.Write(ref _gaps, _gaps + 1);
        _even.Add(step, lost, known);
        Volatile.Write(ref _unsettled, _even.Excess);
        if (_even.Count >= ReductionRun && _even.IsMostlyDivisor && _even.Divisor <= LargestReduction)
            Reduce();
    }

    // The server never sent the frames between the steps of the run.
    private void Reduce()
    {
        ulong sent = _even.Sum <= LargestDelay ? ulong.MaxValue << (int)_even.Sum : 0;
        for (uint back = 0; back <= LargestDelay; back += _even.Divisor)
            sent |= 1UL << (int)back;

        _missing &= sent;
        Volatile.Write(ref _step, (int)_even.Divisor);
        Volatile.Write(ref _lost, Math.Max(_lost - _even.Excess, 0));
        Volatile.Write(ref _gaps, Math.Max(_gaps - _even.AtDivisor, 0));
        EndRun();
    }

    private IndexChange OnLate(uint index, int back)
    {
        ulong bit = 1UL << back;
        if ((_missing & bit) != 0)
        {
            _missing &= ~bit;
            _lateRun = 0;
            Volatile.Write(ref _outOfOrder, _outOfOrder + 1);
            Volatile.Write(ref _lost, Math.Max(_lost - 1, 0));

            // The frame closes a gap of one, shortens a gap at its edge, or splits a gap in two.
            int neighbours = MissingAt(back - _step) + MissingAt(back + _step);
            Volatile.Write(ref _gaps, Math.Max(_gaps + neighbours - 1, 0));

            // This frame shows that the server does send the frames between the steps: swapped neighbours step as evenly as a reduced frequency.
            if (back < _even.Sum && back % _even.Divisor != 0)
                EndRun();
            return IndexChange.Late;
        }

        uint step = index - _lateIndex;
        bool continues = _lateRun > 0 && step is > 0 and <= LargestReduction && (_lateRun == 1 || step == _lateStep);
        _lateRun = continues ? _lateRun + 1 : 1;
        _lateIndex = index;
        _lateStep = step;
        if (_lateRun < RestartRun)
        {
            Volatile.Write(ref _outOfOrder, _outOfOrder + 1);
            return back == 0 ? IndexChange.Same : IndexChange.Late;
        }

        Volatile.Write(ref _outOfOrder, Math.Max(_outOfOrder - (RestartRun - 1), 0));
        return Restart(index);
    }

    private IndexChange Restart(uint index)
    {
        Volatile.Write(ref _restarts, _restarts + 1);
        StartAt(index);
        return IndexChange.Restart;
    }

    private int MissingAt(int back) => back is >= 0 and <= LargestDelay ? (int)((_missing >> back) & 1) : 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Advance(uint next, uint step)
    {
        _newest = next;
        _missing = step <= LargestDelay ? _missing << (int)step : 0;
        _lateRun = 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void EndRun()
    {
        if (_even.Count == 0)
            return;

        _even = default;
        Volatile.Write(ref _unsettled, 0);
    }

    // A run of steps above the known step, and their greatest common divisor.
    private struct EvenSteps
    {
        private long _lost;

        public int Count { get; private set; }

        public uint Divisor { get; private set; }

        public long Sum { get; private set; }

        // How many steps equal the divisor. If the divisor is the server's step, these lead from one frame to the next.
        public int AtDivisor { get; private set; }

        public readonly bool IsMostlyDivisor => AtDivisor * 2 > Count;

        // How many frames counted as lost were never sent, if the divisor is the server's step.
        public readonly long Excess => Count == 0 ? 0 : _lost - ((Sum / Divisor) - Count);

        public void Add(uint step, uint lost, uint known)
        {
            uint divisor = Count == 0 ? step : GreatestCommonDivisor(Divisor, step);
            if (divisor <= known)
            {
                this = default;
                divisor = step;
            }

            if (divisor != Divisor)
                AtDivisor = 0;

            Divisor = divisor;
            AtDivisor += step == divisor ? 1 : 0;
            Count++;
            Sum += step;
            _lost += lost;
        }

        private static uint GreatestCommonDivisor(uint a, uint b)
        {
            while (b != 0)
                (a, b) = (b, a % b);

            return a;
        }
    }
}
