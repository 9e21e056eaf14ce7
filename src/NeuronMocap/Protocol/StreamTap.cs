using System.Net;

namespace NeuronMocap.Protocol;

// Shows every piece of bytes as it arrived, before anything is made of it, to whoever records it. While nobody does, a piece costs a comparison.
//
// Opening, pieces and closing come one after the other, on threads that hand over to each other. A listener may come and go on any thread in
// between: the lock makes it see a connection either as one that stands already or as one that opens.
internal sealed class StreamTap
{
    private readonly object _lock = new();
    private volatile IStreamListener[]? _listeners;
    private StreamConnection? _open;
    private int _connections;

    // Receive thread. The sender is the address of a datagram's sender as the system writes it, otherwise empty; the source numbers it.
    public void OnBytes(int source, byte[] sender, ReadOnlySpan<byte> bytes, long timestamp)
    {
        if (_listeners is { } listeners)
            Tell(listeners, source, sender, bytes, timestamp);
    }

    public void Open(bool isDatagrams, EndPoint? local, EndPoint? remote, long timestamp)
    {
        lock (_lock)
        {
            _open = new StreamConnection(_connections++, isDatagrams, local, remote);
            foreach (IStreamListener listener in _listeners ?? [])
                listener.OnOpened(_open, wasOpen: false, timestamp);
        }
    }

    // Of a connection that never came to stand, nothing is told.
    public void Close(string reason, long timestamp)
    {
        lock (_lock)
        {
            if (_open is null)
                return;

            _open = null;
            foreach (IStreamListener listener in _listeners ?? [])
                listener.OnClosed(reason, timestamp);
        }
    }

    public void Add(IStreamListener listener, long timestamp)
    {
        lock (_lock)
        {
            if (_open is { } open)
                listener.OnOpened(open, wasOpen: true, timestamp);

            _listeners = [.. _listeners ?? [], listener];
        }
    }

    // A piece that is just being told may still reach it.
    public void Remove(IStreamListener listener)
    {
        lock (_lock)
        {
            IStreamListener[] rest = [.. (_listeners ?? []).Where(other => other != listener)];
            _listeners = rest.Length > 0 ? rest : null;
        }
    }

    private static void Tell(IStreamListener[] listeners, int source, byte[] sender, ReadOnlySpan<byte> bytes, long timestamp)
    {
        foreach (IStreamListener listener in listeners)
            listener.OnBytes(source, sender, bytes, timestamp);
    }
}

// Called one at a time. May neither wait nor throw.
internal interface IStreamListener
{
    void OnOpened(StreamConnection connection, bool wasOpen, long timestamp);

    void OnBytes(int source, byte[] sender, ReadOnlySpan<byte> bytes, long timestamp);

    void OnClosed(string reason, long timestamp);
}

internal sealed record StreamConnection(int Number, bool IsDatagrams, EndPoint? Local, EndPoint? Remote);
