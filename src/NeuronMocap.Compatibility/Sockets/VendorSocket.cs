using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Sockets;

// What a handle stands for. Open is called once, by the thread that asked for the handle; Dispose, which closes it, by anyone at any time.
internal abstract class VendorSocket : IDisposable
{
    // How long closing waits for a callback that runs, about as long as the vendor's libraries. It may wait for the thread that closes. Set by tests: on a
    // busy machine the system holds any callback up for longer.
    public static TimeSpan CloseTimeout { get; set; } = TimeSpan.FromMilliseconds(75);

    // How many this thread is opening: a callback of one may ask for another.
    [ThreadStatic]
    private static int _opening;

    private readonly ManualResetEventSlim _opened = new();
    private readonly ManualResetEventSlim _endReported = new();
    private volatile bool _isOpen;
    private volatile bool _hasEnded;
    private int _isClosed;

    // Given by the table.
    public IntPtr Handle { get; set; }

    public virtual SocketState State => (_hasEnded || IsClosed, _isOpen) switch
    {
        (true, _) => SocketState.OffWork,
        (_, true) => SocketState.Running,
        _ => SocketState.Starting,
    };

    // Whatever the program's callbacks are called through.
    protected CallbackGate Gate { get; } = new();

    protected bool IsClosed => Volatile.Read(ref _isClosed) != 0;

    // Whether another call asks for what this one already is.
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
            // The program may interrupt or abort its thread, and others wait for this one.
            if (!stands)
                _hasEnded = true;

            _opening--;
            _opened.Set();
        }
    }

    // For whoever asks for a connection that somebody is making. A callback on a thread that makes one itself does not wait: it may be this one, or one
    // whose callback asks for that of the caller.
    public bool WaitUntilOpen()
    {
        if (_opening == 0)
            _opened.Wait();

        return State != SocketState.OffWork;
    }

    public void Dispose() => Close(CloseTimeout);

    // False where a callback still runs that is waited for no longer. None begins after this, whoever closes how often: one thread tells the end, and
    // the others wait for that, too.
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

    // One that nobody has a handle of, or that is replaced: it has ended already, and nobody closes it.
    public void Abandon()
    {
        Volatile.Write(ref _isClosed, 1);
        Gate.Close();
        _endReported.Set();
        BeginRelease();
    }

    // Whether it stands.
    protected abstract bool TryOpen();

    // Ends everything, as far as that can be done without waiting.
    protected abstract void BeginRelease();

    // No callback runs. Returns when nothing else does, or when that takes very long.
    protected abstract void WaitUntilReleased();

    protected virtual void OnClosed()
    {
    }

    // The end is being told: it has come before whoever else closes returns.
    protected void SetEndReported() => _endReported.Set();

    protected void SetOpen()
    {
        _isOpen = true;
        _hasEnded = false;
    }

    protected void SetOver() => _hasEnded = true;

    // Holds frames and the end of a connection back until its beginning was told.
    protected void WaitUntilOpenReported()
    {
        if (!_opened.IsSet)
            _opened.Wait();
    }
}
