using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Transport;

namespace NeuronMocap.Server.Clients;

/// <summary>A TCP connection of our own listener.</summary>
internal sealed class SocketTransport : ClientTransport
{
    // Not every runtime ends a wait when its socket closes.
    private const int PollMilliseconds = 500;

    private readonly Socket _socket;
    private readonly int _sendTimeout;
    private bool _isDirect;
    private volatile bool _isDisposed;

    /// <summary>Takes over a socket.</summary>
    /// <param name="socket">The socket. It is not disposed if this throws.</param>
    /// <param name="sendTimeout">Time after which a client that does not read is given up.</param>
    /// <param name="sendBufferSize">Size of the system's buffer in bytes; null for the default.</param>
    /// <exception cref="SocketException">The client reset the connection before it was served.</exception>
    public SocketTransport(Socket socket, TimeSpan sendTimeout, int? sendBufferSize = null)
    {
        _socket = socket;
        RemoteEndPoint = socket.RemoteEndPoint;
        socket.NoDelay = true;
        if (sendBufferSize is { } size)
            socket.SendBufferSize = size;

        // A client that vanished reads nothing more. The wait for buffer space ends only when about a third of the buffer is free.
        _sendTimeout = (int)sendTimeout.TotalMilliseconds;
        socket.SendTimeout = _sendTimeout;
        // While nothing is sent, only a keep-alive probe can detect that the client is gone.
        TcpKeepAlive.Enable(socket);
    }

    public override EndPoint? RemoteEndPoint { get; }

    public override bool IsLeft
    {
        get
        {
            try
            {
                // Another thread may take received bytes between the two calls. An end stays.
                return HasEnd() && HasEnd();
            }
            catch (Exception exception) when (SocketErrors.IsExpected(exception))
            {
                return true;
            }
        }
    }

    private bool HasEnd() => _socket.Poll(0, SelectMode.SelectRead) && _socket.Available == 0;

    public override bool TryStopWaiting()
    {
        _socket.Blocking = false;
        return _isDirect = true;
    }

    public override SocketError TrySend(byte[] buffer, int offset, int count, out int sent)
    {
        SocketError error;
        do
        {
            sent = _socket.Send(buffer, offset, count, SocketFlags.None, out error);
        }
        while (error == SocketError.WouldBlock && _isDirect && WaitForRoom());

        return error;
    }

    public override SocketError TrySendNow(byte[] buffer, int offset, int count, out int sent)
    {
        sent = _socket.Send(buffer, offset, count, SocketFlags.None, out SocketError error);
        return error;
    }

    public override bool HasRoom(int milliseconds) => _socket.Poll(milliseconds * 1000, SelectMode.SelectWrite);

    public override bool TryReceiveNow(ArraySegment<byte> room, out int count)
    {
        count = _socket.Receive(room.Array!, room.Offset, room.Count, SocketFlags.None, out SocketError error);
        return error == SocketError.Success;
    }

    public override async ValueTask<int> ReceiveAsync(Memory<byte> room) => await _socket.ReceiveAsync(room, SocketFlags.None).ConfigureAwait(false);

    public override int Receive(ArraySegment<byte> room, int timeout)
    {
        _socket.ReceiveTimeout = timeout;
        return _socket.Receive(room.Array!, room.Offset, room.Count, SocketFlags.None);
    }

    public override void EndSending() => _socket.Shutdown(SocketShutdown.Send);

    // Nobody will read the data queued for a client that is disconnected, but the system would keep trying. Closing then resets the connection.
    public override void DropUnsent() => _socket.LingerState = new LingerOption(enable: true, seconds: 0);

    // Closing alone resets a connection in the middle of a write, or with unread bytes. After a shutdown the client reads the sent bytes and then sees the
    // end.
    public override void Dispose()
    {
        _isDisposed = true;
        try
        {
            _socket.Shutdown(SocketShutdown.Send);
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            // The client or the server already closed it.
        }

        _socket.Dispose();
    }

    // Returns false when the time is over, or when this connection is disposed.
    private bool WaitForRoom()
    {
        var watch = Stopwatch.StartNew();
        while (!_isDisposed)
        {
            double left = _sendTimeout < 0 ? PollMilliseconds : Math.Min(_sendTimeout - watch.Elapsed.TotalMilliseconds, PollMilliseconds);
            if (left <= 0)
                return false;
            if (_socket.Poll((int)(left * 1000), SelectMode.SelectWrite))
                return true;
        }

        return false;
    }
}
