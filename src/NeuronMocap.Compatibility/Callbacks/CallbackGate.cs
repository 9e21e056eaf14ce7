using System.Diagnostics;

namespace NeuronMocap.Compatibility.Callbacks;

// Allows the callbacks of one socket until the socket is closed, and knows whether a callback is running. Closing waits for running callbacks, but
// only briefly, because a callback may wait for the thread that closes.
internal sealed partial class CallbackGate
{
    private static readonly object Lock = new();

    // The gates in which callbacks may run: those of open sockets, and those of closed sockets whose last callback has not ended.
    private static readonly HashSet<CallbackGate> Gates = [];
    private static bool _isProcessEnding;

    // Guarded by the lock. Status callbacks are rare. They may run on any thread, and several may run at once.
    private readonly List<int> _reportingThreads = [];

    // The thread that runs a callback of the stream, or 0. Only one thread at a time runs such a callback, and only that thread writes this field.
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

    // Receive thread, with its managed number. If it returns true, EndDelivery must follow.
    public bool TryBeginDelivery(int thread)
    {
        // This method announces the callback before it checks for closing. Close announces closing before it checks for callbacks. So one of them
        // sees the other.
        _deliveringThread = thread;
        FenceDelivery();
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

    // Any thread. If it returns true, EndReport must follow on the same thread. The closing thread reports the end, after closing.
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

    // No callback starts after this call.
    public void Close()
    {
        _isClosed = true;
        FenceClosing();
        Retire();
    }

    // Waits until no callback runs, except callbacks on the calling thread. Returns false on a time-out.
    public bool WaitUntilIdle(TimeSpan timeout) => Wait(() => IsBusyOnOtherThread, timeout);

    // Waits like WaitUntilIdle, but for status callbacks only.
    public bool WaitUntilReported(TimeSpan timeout) => Wait(() => IsReportingOnOtherThread, timeout);

    // Waits like WaitUntilIdle, but for the callbacks of all closed gates. Closing did not wait for these callbacks.
    public static bool WaitUntilClosedAreIdle(TimeSpan timeout) => Wait(
        static () =>
        {
            lock (Lock)
                return Gates.Any(static gate => gate._isClosed && gate.IsBusyOnOtherThread);
        },
        timeout);

    // After this call no callback of any socket starts. The objects that callbacks use are about to be destroyed.
    public static bool EndProcess(TimeSpan timeout)
    {
        lock (Lock)
        {
            _isProcessEnding = true;
            foreach (CallbackGate gate in Gates)
                gate._isClosed = true;
        }

        FenceClosing();
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

    // Polls. A signal would slow down every callback, although only closing needs it.
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

    // Removes all idle closed gates. A delivery that ends while its gate is closed may not notice it. Its gate then stays until the next call.
    private static void Retire()
    {
        lock (Lock)
            Gates.RemoveWhere(static gate => gate._isClosed && gate.IsIdle);
    }
}
