using System.Diagnostics;

namespace NeuronMocap.Compatibility.Callbacks;

// Lets the callbacks of one socket begin until it is closed, and tells whether one runs. Closing waits for those that run, but not for long: they may
// wait for the very thread that closes.
internal sealed class CallbackGate
{
    private static readonly object Lock = new();

    // Those in which callbacks may run: of sockets that are open, and of closed ones whose last callback has not ended.
    private static readonly HashSet<CallbackGate> Gates = [];
    private static bool _isProcessEnding;

    // Under the lock. Threads in status callbacks, which are rare, may be any, and several at once.
    private readonly List<int> _reportingThreads = [];

    // The thread in a callback of the stream, 0 for none. There is one at a time, which alone writes this.
    private volatile int _deliveringThread;
    private volatile bool _isClosed;

    public CallbackGate()
    {
        lock (Lock)
        {
            _isClosed = _isProcessEnding;
            Gates.Add(this);
        }
    }

    private bool IsIdle => _deliveringThread == 0 && _reportingThreads.Count == 0;

    // Receive thread. Where it is true, EndDelivery has to follow.
    public bool TryBeginDelivery()
    {
        // Says that it begins before it looks, as Close closes before it looks: one of the two sees the other.
        _deliveringThread = Environment.CurrentManagedThreadId;
        Interlocked.MemoryBarrier();
        if (!_isClosed)
            return true;

        EndDelivery();
        return false;
    }

    public void EndDelivery()
    {
        _deliveringThread = 0;
        if (_isClosed)
            Retire();
    }

    // Any thread. Where it is true, EndTelling has to follow, on the same thread. The end is told after closing, by the thread that closes.
    public bool TryBeginReport(bool isEnd)
    {
        lock (Lock)
        {
            if (_isProcessEnding || (_isClosed && !isEnd))
                return false;

            _reportingThreads.Add(Environment.CurrentManagedThreadId);
            return true;
        }
    }

    public void EndReport()
    {
        lock (Lock)
            _reportingThreads.Remove(Environment.CurrentManagedThreadId);

        Retire();
    }

    // From here on no callback begins.
    public void Close()
    {
        _isClosed = true;
        Interlocked.MemoryBarrier();
        Retire();
    }

    // Whether no callback runs, those aside that the calling thread is in.
    public bool WaitUntilIdle(TimeSpan timeout) => Wait(() => IsBusyOnOtherThread, timeout);

    // The same for status callbacks alone.
    public bool WaitUntilReported(TimeSpan timeout) => Wait(() => IsReportingOnOtherThread, timeout);

    // As the one of a gate, for all callbacks that closing did not wait for.
    public static bool WaitUntilClosedAreIdle(TimeSpan timeout) => Wait(
        static () =>
        {
            lock (Lock)
                return Gates.Any(static gate => gate._isClosed && gate.IsBusyOnOtherThread);
        },
        timeout);

    // No callback of any socket begins any more, and the objects that callbacks use are about to be destroyed.
    public static bool EndProcess(TimeSpan timeout)
    {
        lock (Lock)
        {
            _isProcessEnding = true;
            foreach (CallbackGate gate in Gates)
                gate._isClosed = true;
        }

        Interlocked.MemoryBarrier();
        return WaitUntilClosedAreIdle(timeout);
    }

    private bool IsBusyOnOtherThread
    {
        get
        {
            int thread = Environment.CurrentManagedThreadId;
            return (_deliveringThread is not 0 and int delivering && delivering != thread) || IsReportingOnOtherThread;
        }
    }

    private bool IsReportingOnOtherThread
    {
        get
        {
            int thread = Environment.CurrentManagedThreadId;
            lock (Lock)
                return _reportingThreads.Exists(telling => telling != thread);
        }
    }

    // By looking: a signal would cost every callback what only closing needs.
    private static bool Wait(Func<bool> isBusy, TimeSpan timeout)
    {
        var watch = Stopwatch.StartNew();
        while (isBusy())
        {
            if (watch.Elapsed >= timeout)
                return false;

            Thread.Sleep(1);
        }

        return true;
    }

    // All of them: a delivery that ends while its gate is closed may not see that, and its gate stays until the next one.
    private static void Retire()
    {
        lock (Lock)
            Gates.RemoveWhere(static gate => gate._isClosed && gate.IsIdle);
    }
}
