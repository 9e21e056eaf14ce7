using System.Diagnostics;

namespace NeuronMocap.Reader;

// Checks a reader now and then, and seldom while it has nothing to find out. A computer that waits for a suit should stay asleep. The seldom checks of all
// readers of a process fall into the same instants, so their number does not grow with the readers.
internal sealed class Watchdog : IDisposable
{
    // Ordinary checks without a finding before checks become seldom, and how many a seldom one replaces. The reports that still wait then are made before.
    public const int Idleness = 60;

    private readonly object _lock = new();
    private readonly Action<long> _check;
    private readonly Func<bool> _isIdle;
    private readonly Timer _timer;
    private readonly TimeSpan _ordinary;
    private TimeSpan _period;
    private int _idleChecks;
    private bool _isDisposed;

    // check and isIdle: any thread. isIdle must not wait. Whoever changes its answer calls Adjust.
    public Watchdog(TimeSpan ordinary, Action<long> check, Func<bool> isIdle)
    {
        _isIdle = isIdle;
        _ordinary = ordinary;
        _period = ordinary;
        _check = check;
        _timer = new Timer(static watchdog => ((Watchdog)watchdog!).Check(), this, Timeout.Infinite, Timeout.Infinite);
        _timer.Change(ordinary, ordinary);
    }

    // Time between two checks.
    public TimeSpan Period
    {
        get
        {
            lock (_lock)
                return _period;
        }
    }

    // The timer calls it.
    public void Check()
    {
        _check(Stopwatch.GetTimestamp());
        Adjust(checks: 1);
    }

    // The answer may have changed. The last call sees the last change, because the answer is asked for under the lock.
    public void Adjust() => Adjust(checks: 0);

    private void Adjust(int checks)
    {
        lock (_lock)
        {
            if (_isDisposed)
                return;

            _idleChecks = _isIdle() ? Math.Min(Idleness, _idleChecks + checks) : 0;
            bool isSeldom = _idleChecks == Idleness;
            TimeSpan period = isSeldom ? TimeSpan.FromTicks(_ordinary.Ticks * Idleness) : _ordinary;
            if (period == _period)
                return;

            _period = period;
            _timer.Change(isSeldom ? NextShared(TimeSpan.FromSeconds(Stopwatch.GetTimestamp() / (double)Stopwatch.Frequency), period) : period, period);
        }
    }

    // Time from now to the next multiple of the period, on the clock that all readers share.
    public static TimeSpan NextShared(TimeSpan now, TimeSpan period) => TimeSpan.FromTicks(period.Ticks - (now.Ticks % period.Ticks));

    public void Dispose()
    {
        lock (_lock)
        {
            _isDisposed = true;
            _timer.Dispose();
        }
    }
}
