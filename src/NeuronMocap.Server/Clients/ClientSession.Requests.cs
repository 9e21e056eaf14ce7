using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Clients;

// The requests of the client.
internal sealed partial class ClientSession
{
    // The pause in milliseconds between two reads of requests. A flood of requests wakes the sender no more often and waits in the client's own
    // connection.
    private const int ListeningPause = 10;

    // The longest wait in milliseconds of a client that keeps up.
    private const int ShortWait = 20;

    private readonly RequestScanner _scanner = new();

    // Whether this session's thread looks for requests between two writes. It does so at full speed, as long as the client reads: a socket with an asynchronous
    // receive wakes two more threads each time it has room again.
    private bool _listensHere;
    private bool _hasClosed;
    private Task _listened = Task.CompletedTask;
    private volatile bool _isFinishing;

    private void BeginListening()
    {
        if (!_listensHere)
            _listened = ListenAsync();
    }

    private void ListenNow()
    {
        if (!_listensHere || _hasClosed || !_transport.TryReceiveNow(_scanner.Segment, out int read))
            return;

        _hasClosed = read == 0;
        _ = Accept(read);
    }

    // The same as the transport's TrySend. A client that does not read for a while may send all the same.
    private SocketError TrySendSoon(byte[] bytes, int offset, int count, out int sent)
    {
        SocketError error = _transport.TrySendNow(bytes, offset, count, out sent);
        if (error != SocketError.WouldBlock)
            return error;
        if (!_transport.HasRoom(ShortWait))
            ListenElsewhere();

        return _transport.TrySend(bytes, offset, count, out sent);
    }

    private void ListenElsewhere()
    {
        if (_listensHere && !_hasClosed)
            _listened = ListenAsync();

        _listensHere = false;
    }

    private void FinishListening()
    {
        _isFinishing = true;
        ListenElsewhere();
        _listened.Wait(_closeTimeout);
    }

    // Ends when the client closes its sending side or the connection is gone. A closed sending side is not a reason to stop sending to the client.
    private async Task ListenAsync()
    {
        try
        {
            int read;
            while ((read = await _transport.ReceiveAsync(_scanner.Room).ConfigureAwait(false)) > 0)
            {
                if (Accept(read) && !_isFinishing)
                    await Task.Delay(ListeningPause).ConfigureAwait(false);
            }
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException or OutOfMemoryException)
        {
            // The next write reports the error.
        }
    }

    // Returns whether the bytes hold requests that cause work.
    private bool Accept(int read)
    {
        _scanner.Advance(read);
        bool hasRequests = false;
        while (_scanner.TryRead(out DataCommandHeader request))
            hasRequests |= Accept(request, _scanner.Request);

        return hasRequests;
    }

    // Returns whether the request causes work.
    private bool Accept(in DataCommandHeader request, ReadOnlySpan<byte> bytes)
    {
        if (Stream.Forwarder is { } forwarder)
        {
            forwarder.Add(this, request, bytes);
            return true;
        }

        bool hasReplies = Commands?.Accept(request) ?? false;
        if (hasReplies)
            Feed.Wake();

        return hasReplies;
    }
}
