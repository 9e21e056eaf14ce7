using System.Net;

namespace NeuronMocap.Protocol;

// Shows every piece of bytes as it arrived, before anything is made of it, to whoever records it. While nobody does, a piece costs a comparison.
//
// Opening, pieces and closing come one after the other, on threads that hand over to each other. A listener may come and go on any thread in
// between: the lock makes it see a connection either as one that stands already or as one that opens. Where a reader has two connections, each has a
// tap of its own; they share listeners, and the receive lock of the reader keeps their threads apart. Handlers hold it when they add a listener, so
// it is always taken before the lock.
internal sealed class StreamTap
{
    private readonly object? _receiveLock;
    private readonly StreamTap _first;
    private readonly bool _isCalculation;

    // The first one's, for all of them.
    private readonly object _lock = new();
    private readonly List<StreamTap> _taps = [];
    private volatile IStreamListener[]? _listeners;
    private int _connections;

    private volatile StreamConnection? _open;

    public StreamTap(object? receiveLock = null)
    {
        _receiveLock = receiveLock;
        _first = this;
        _taps.Add(this);
    }

    private StreamTap(StreamTap first)
    {
        _receiveLock = first._receiveLock;
        _first = first;
        _isCalculation = true;
        first._taps.Add(this);
    }

    public bool IsListened => _first._listeners is not null;

    // For the connection of a calculation port; before anything is received.
    public StreamTap AddCalculation() => new(this);

    // Receive thread. The sender is the address of a datagram's sender as the system writes it, otherwise empty; its number is that of this
    // address and port alone.
    public void OnBytes(int number, byte[] sender, ReadOnlySpan<byte> bytes, long timestamp)
    {
        if (_first._listeners is not { } listeners)
            return;

        if (_receiveLock is null)
        {
            Notify(listeners, number, sender, bytes, timestamp);
            return;
        }

        lock (_receiveLock)
            Notify(listeners, number, sender, bytes, timestamp);
    }

    public void Open(bool isDatagrams, EndPoint? local, EndPoint? remote, long timestamp)
    {
        lock (_receiveLock ?? _first._lock)
        {
            lock (_first._lock)
            {
                _open = new StreamConnection(_first._connections++, isDatagrams, local, remote) { IsCalculation = _isCalculation };
                foreach (IStreamListener listener in _first._listeners ?? [])
                    listener.OnOpened(_open, wasOpen: false, timestamp);
            }
        }
    }

    // Of a connection that never came to stand, nothing is told.
    public void Close(string reason, long timestamp)
    {
        lock (_receiveLock ?? _first._lock)
        {
            lock (_first._lock)
            {
                if (_open is not { } open)
                    return;

                _open = null;
                foreach (IStreamListener listener in _first._listeners ?? [])
                    listener.OnClosed(open, reason, timestamp);
            }
        }
    }

    public void Add(IStreamListener listener, long timestamp)
    {
        lock (_first._lock)
        {
            foreach (StreamTap tap in _first._taps)
            {
                if (tap._open is { } open)
                    listener.OnOpened(open, wasOpen: true, timestamp);
            }

            _first._listeners = [.. _first._listeners ?? [], listener];
        }
    }

    // A piece that is just being told may still reach it.
    public void Remove(IStreamListener listener)
    {
        lock (_first._lock)
        {
            IStreamListener[] rest = [.. (_first._listeners ?? []).Where(other => other != listener)];
            _first._listeners = rest.Length > 0 ? rest : null;
        }
    }

    private void Notify(IStreamListener[] listeners, int number, byte[] sender, ReadOnlySpan<byte> bytes, long timestamp)
    {
        if (_open is not { } open)
            return;

        foreach (IStreamListener listener in listeners)
            listener.OnBytes(open, number, sender, bytes, timestamp);
    }
}

// Called one at a time. May neither wait nor throw.
internal interface IStreamListener
{
    void OnOpened(StreamConnection connection, bool wasOpen, long timestamp);

    void OnBytes(StreamConnection connection, int number, byte[] sender, ReadOnlySpan<byte> bytes, long timestamp);

    void OnClosed(StreamConnection connection, string reason, long timestamp);
}

internal sealed record StreamConnection(int Number, bool IsDatagrams, EndPoint? Local, EndPoint? Remote)
{
    // Whether it is that of the calculation port, beside the reader's first one.
    public bool IsCalculation { get; init; }
}
