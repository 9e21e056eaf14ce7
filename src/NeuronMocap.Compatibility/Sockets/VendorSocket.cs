using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Sockets;

// The object behind a handle. Open is called once, by the thread that asked for the handle. Dispose closes the socket, on any thread and at any time.
internal abstract class VendorSocket : IDisposable
{
    // How long closing waits for a running callback, about as long as the vendor's libraries. The callback may wait for the thread that closes. Tests
    // set a longer time, because any callback can be delayed on a busy machine.
    public static TimeSpan CloseTimeout { get; set; } = TimeSpan.FromMilliseconds(75);

    // The number of sockets that this thread is opening. A callback during one opening may ask for another socket.
    [ThreadStatic]
    private static int _opening;

    private readonly ManualResetEventSlim _opened = new();
    private readonly ManualResetEventSlim _endReported = new();
    private volatile bool _isOpen;
    private volatile bool _hasEnded;
    private int _isClosed;

    // Set by the table.
    public IntPtr Handle { get; set; }

    public virtual SocketState State => (_hasEnded || IsClosed, _isOpen) switch
    {
        (true, _) => SocketState.OffWork,
        (_, true) => SocketState.Running,
        _ => SocketState.Starting,
    };

    // The gate through which the program's callbacks are called.
    protected CallbackGate Gate { get; } = new();

    protected bool IsClosed => Volatile.Read(ref _isClosed) != 0;

    // Whether this socket already has the target of the other one.
    public abstract bool IsTo(VendorSocket other);

    public bool Open()
    {
        bool stands = false;
        _opening++;
        try
        {
            stands = TryOpen();
            return stands && !IsClosed;
        }
        finally
        {
            // The program may interrupt or abort its thread while other threads wait for this one.
            if (!stands)
                _hasEnded = true;

            _opening--;
            _opened.Set();
        }
    }

    // Waits for a connection that another thread is opening. A callback on a thread that is itself opening a socket does not wait: it may be waiting
    // for that very socket, or for a socket whose callback waits for the caller's socket.
    public bool WaitUntilOpen()
    {
        if (_opening == 0)
            _opened.Wait();

        return State != SocketState.OffWork;
    }

    public void Dispose() => Close(CloseTimeout);

    // Returns false if a callback is still running after the timeout. No callback starts after this method, however many threads close the socket.
    // One thread reports the end, and the other threads wait for the report.
    public bool Close(TimeSpan timeout)
    {
        bool isFirst = Interlocked.Exchange(ref _isClosed, 1) == 0;
        try
        {
            Gate.Close();
            _opened.Set();
            BeginRelease();
            bool isIdle = Gate.WaitUntilIdle(timeout);
            if (isIdle)
                WaitUntilReleased();

            SocketTable.Remove(this);
            if (isFirst)
            {
                OnClosed();
            }
            else
            {
                _endReported.Wait();
                Gate.WaitUntilReported(timeout);
            }

            return isIdle;
        }
        finally
        {
            if (isFirst)
                _endReported.Set();
        }
    }

    // For a socket without a handle, or one that is replaced. It has already ended, and no caller closes it.
    public void Abandon()
    {
        Volatile.Write(ref _isClosed, 1);
        Gate.Close();
        _endReported.Set();
        BeginRelease();
    }

    // Returns whether the connection or service is open.
    protected abstract bool TryOpen();

    // Ends everything, as far as possible without waiting.
    protected abstract void BeginRelease();

    // Called when no callback runs. Returns when all other work has ended, or after a long time-out.
    protected abstract void WaitUntilReleased();

    protected virtual void OnClosed()
    {
    }

    // The end is being reported. Other threads that close the socket return only after the report.
    protected void SetEndReported() => _endReported.Set();

    protected void SetOpen()
    {
        _isOpen = true;
        _hasEnded = false;
    }

    protected void SetOver() => _hasEnded = true;

    // Delays frames and the end of a connection until its start has been reported.
    protected void WaitUntilOpenReported()
    {
        if (!_opened.IsSet)
            _opened.Wait();
    }
}
