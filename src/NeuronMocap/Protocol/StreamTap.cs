using System.Net;

namespace NeuronMocap.Protocol;

// Passes every piece of bytes to recordings as it arrived, before it is parsed. Without a recording, a piece costs one comparison.
//
// Open, OnBytes and Close are called one after another, on threads that hand over to each other. Other threads can add and remove listeners at any time.
// The lock ensures that a listener sees a connection either as already open or as opening. A reader with two connections has a tap for each. The taps
// share their listeners, and the receive lock of the reader separates their threads. Handlers hold the receive lock when they add a listener, so it is
// always taken before the lock.
internal sealed class StreamTap
{
    private readonly object? _receiveLock;
    private readonly StreamTap _first;
    private readonly bool _isCalculation;

    // All taps use the lock of the first tap.
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

    // For the connection of a calculation port. Called before anything is received.
    public StreamTap AddCalculation() => new(this);

    // Receive thread. The sender is the address of the datagram's sender, in the format of the system, or empty for TCP. Its number identifies this
    // address and port.
    public void OnBytes(int number, byte[] sender, ArraySegment<byte> bytes, long timestamp)
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

    // Reports nothing for a connection that was never established.
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

    // The listener may still receive a piece that is being passed on at this moment.
    public void Remove(IStreamListener listener)
    {
        lock (_first._lock)
        {
            IStreamListener[] rest = [.. (_first._listeners ?? []).Where(other => other != listener)];
            _first._listeners = rest.Length > 0 ? rest : null;
        }
    }

    private void Notify(IStreamListener[] listeners, int number, byte[] sender, ArraySegment<byte> bytes, long timestamp)
    {
        if (_open is not { } open)
            return;

        foreach (IStreamListener listener in listeners)
            listener.OnBytes(open, number, sender, bytes, timestamp);
    }
}

// Called one at a time. Implementations must not wait or throw.
internal interface IStreamListener
{
    void OnOpened(StreamConnection connection, bool wasOpen, long timestamp);

    // The bytes belong to the caller, and are valid and unchanged during the call.
    void OnBytes(StreamConnection connection, int number, byte[] sender, ArraySegment<byte> bytes, long timestamp);

    void OnClosed(StreamConnection connection, string reason, long timestamp);
}

internal sealed record StreamConnection(int Number, bool IsDatagrams, EndPoint? Local, EndPoint? Remote)
{
    // Whether this is the connection of the calculation port, beside the reader's first connection.
    public bool IsCalculation { get; init; }
}
