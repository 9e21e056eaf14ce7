using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Sockets;

// What a handle stands for. Open is called once, by the thread that asked for the handle; Dispose, which closes it, by anyone at any time.
internal abstract class VendorSocket : IDisposable
{
    // How many this thread is opening: a callback of one may ask for another.
    [ThreadStatic]
    private static int _opening;

    private readonly ManualResetEventSlim _opened = new();
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
                _isOver = true;

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
