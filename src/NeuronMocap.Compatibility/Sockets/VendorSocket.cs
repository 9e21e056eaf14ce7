using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Sockets;

// What a handle stands for. Open is called once, by the thread that asked for the handle; Dispose, which closes it, by anyone at any time.
internal abstract class VendorSocket : IDisposable
{
    private readonly ManualResetEventSlim _opened = new();
    private int _openingThread;
    private volatile bool _isOpen;
    private volatile bool _isOver;
    private int _isClosed;

    // Given by the table.
    public IntPtr Handle { get; set; }

    public virtual SocketState State => (_isOver || IsClosed, _isOpen) switch
    {
        (true, _) => SocketState.OffWork,
        (_, true) => SocketState.Running,
        _ => SocketState.Starting,
    };

    protected bool IsClosed => Volatile.Read(ref _isClosed) != 0;

    // Whether another call asks for what this one already is.
    public abstract bool IsTo(VendorSocket other);

    public bool Open()
    {
        _openingThread = Environment.CurrentManagedThreadId;
        bool stands = false;
        try
        {
            stands = TryOpen();
            return stands && !IsClosed;
        }
        finally
        {
            // The program may interrupt or abort its thread, and others wait for this one.
            if (!stands)
                _isOver = true;

            _opened.Set();
        }
    }

    // For whoever asks for a connection that somebody is making. A callback that does, on the thread that makes it, cannot wait for itself.
    public bool WaitUntilOpen()
    {
        if (Environment.CurrentManagedThreadId != _openingThread)
            _opened.Wait();

        return State != SocketState.OffWork;
    }

    public void Dispose()
    {
        bool isFirst = Interlocked.Exchange(ref _isClosed, 1) == 0;
        _opened.Set();
        Release();
        SocketTable.Remove(this);
        if (isFirst)
            OnClosed();
    }

    // A dead one that is replaced has ended already, and nobody closes it.
    public void Abandon()
    {
        Volatile.Write(ref _isClosed, 1);
        Release();
    }

    // Whether it stands.
    protected abstract bool TryOpen();

    // Ends everything, and returns when no callback runs any more, as far as that can be waited for.
    protected abstract void Release();

    protected virtual void OnClosed()
    {
    }

    protected void SetOpen()
    {
        _isOpen = true;
        _isOver = false;
    }

    protected void SetOver() => _isOver = true;

    // Holds frames and the end of a connection back until its beginning was told.
    protected void WaitUntilTold()
    {
        if (!_opened.IsSet)
            _opened.Wait();
    }
}
