using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// A TCP connection to a server that sends without requests (protocol.md section 4.1); only commands go the other way. TcpReceivers determines how it waits
// for bytes.
internal sealed class TcpLink(LinkOptions options) : Link
{
    // If a server does not read commands, its buffers are soon full. It then delays the sending thread, but never the frames.
    private const int SendTimeoutMilliseconds = 1000;

    private readonly object _lock = new();
    private readonly object _sendLock = new();
    private readonly TcpReceiver _receiver = options.Tls is { } tls ? tls.CreateReceiver(options, tls) : options.TakeReceiver(options.ReceiveThread);
    private Socket? _socket;
    private bool _closed;

    public override string Target => options.Target;

    public override ReceiveThread ReceiveThread => _receiver.Thread;

    public override async Task<LinkEnd> OpenAsync(CancellationToken cancellationToken)
    {
        LinkEnd end = await FindAndConnectAsync(cancellationToken).ConfigureAwait(false);
        return cancellationToken.IsCancellationRequested ? LinkEnd.Requested : end;
    }

    public override async Task<LinkEnd> ReceiveAsync(IPacketReceiver receiver, ILinkListener? listener)
    {
        var assembler = new PacketAssembler(new PacketScanner(options.MaxValues), receiver, listener?.Tap);
        try
        {
            await _receiver.ReceiveAsync(_socket!, assembler).ConfigureAwait(false);
            return FirstReason(new LinkEnd(ConnectionReason.ClosedByPeer, ConnectionMessages.ClosedByPeer(Target)));
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            SocketError error = (exception as SocketException)?.SocketErrorCode ?? SocketError.OperationAborted;
            return FirstReason(error == SocketError.TimedOut
                ? new LinkEnd(ConnectionReason.TimedOut, ConnectionMessages.ConnectionLost(Target))
                : Failed(error, exception));
        }
        finally
        {
            assembler.Abandon();
        }
    }

    // Sends whole requests only, one at a time. After half of a request, the server finds the next one by its tokens.
    public override bool TrySend(ReadOnlySpan<byte> bytes)
    {
        if (RemoteEndPoint is null)
            return false;

        try
        {
            lock (_sendLock)
            {
                // Set only before the first command, because on Linux this timeout would also apply to connecting.
                _socket!.SendTimeout = SendTimeoutMilliseconds;
                return _receiver.TrySend(_socket, bytes);
            }
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            return false;
        }
    }

    public override void Close()
    {
        lock (_lock)
        {
            _closed = true;
            _socket?.Dispose();
        }

        _receiver.Close();
    }

    private async Task<LinkEnd> FindAndConnectAsync(CancellationToken cancellationToken)
    {
        IPAddress[] addresses;
        try
        {
            addresses = await HostResolver.ResolveAsync(options, cancellationToken).ConfigureAwait(false);
        }
        catch (SocketException exception)
        {
            return Failed(exception.SocketErrorCode, exception);
        }
        catch (ArgumentException)
        {
            // The resolver rejects names that no computer can have.
            return new LinkEnd(ConnectionReason.HostNotFound, ConnectionMessages.HostNotFound(options.Host));
        }
        catch (TimeoutException)
        {
            return new LinkEnd(ConnectionReason.TimedOut, ConnectionMessages.ResolverTimedOut(options));
        }

        if (addresses.Length == 0)
            return new LinkEnd(ConnectionReason.HostNotFound, ConnectionMessages.HostNotFound(options.Host));

        LinkEnd? telling = null;
        foreach (IPAddress address in addresses)
        {
            LinkEnd end = await ConnectAsync(address, cancellationToken).ConfigureAwait(false);
            if (end.Reason == ConnectionReason.None || cancellationToken.IsCancellationRequested)
                return end;
            if (telling is not { } other || Weight(end.Reason) > Weight(other.Reason))
                telling = end;
        }

        return telling!.Value;
    }

    private async Task<LinkEnd> ConnectAsync(IPAddress address, CancellationToken cancellationToken)
    {
        // Systems report several errors for this, and some of those errors have other meanings too.
        if (options.LocalAddress is { } own && own.AddressFamily != address.AddressFamily)
            return Failed(SocketError.AddressNotAvailable, new SocketException((int)SocketError.AddressNotAvailable));

        Socket? socket = null;
        var remote = new IPEndPoint(address, options.Port);
        using var timeoutSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
        timeoutSource.CancelAfter(options.ConnectTimeout);
        try
        {
            socket = new Socket(address.AddressFamily, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
            TcpKeepAlive.Enable(socket);
            if (!Adopt(socket))
                return LinkEnd.Requested;

            using (timeoutSource.Token.Register(socket.Dispose))
            {
                if (options.LocalAddress is { } local)
                    socket.Bind(new IPEndPoint(local, 0));

                await _receiver.ConnectAsync(socket, remote).ConfigureAwait(false);
            }

            // The socket is not asked for its remote end point. A socket that was reset in the meantime no longer knows it, and the receive loop must
            // report the reset.
            RemoteEndPoint = remote;
            LocalEndPoint = socket.LocalEndPoint;
            if (!IsOwnEcho(socket, remote))
                return LinkEnd.None;

            socket.Dispose();
            return Failed(SocketError.ConnectionRefused, new SocketException((int)SocketError.ConnectionRefused));
        }
        catch (NeuronConnectionException exception) when (!timeoutSource.IsCancellationRequested)
        {
            socket?.Dispose();
            return new LinkEnd(exception.Reason, exception.Message);
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception) || exception is NeuronConnectionException)
        {
            socket?.Dispose();
            return timeoutSource.IsCancellationRequested
                ? Failed(SocketError.TimedOut, exception)
                : Failed((exception as SocketException)?.SocketErrorCode ?? SocketError.SocketError, exception);
        }
    }

    // On this computer, the system can choose the destination port as the local port. If nothing listens there, the socket connects to itself. It then
    // receives nothing forever, and blocks the port for the server.
    internal static bool IsOwnEcho(Socket socket, EndPoint remote) => remote.Equals(socket.LocalEndPoint);

    // Of several addresses, prefers the one whose answer says the most about the server.
    internal static int Weight(ConnectionReason reason) => reason switch
    {
        ConnectionReason.CertificateRejected or ConnectionReason.TlsFailed => 4,
        ConnectionReason.Refused => 3,
        ConnectionReason.TimedOut => 2,
        ConnectionReason.Unreachable or ConnectionReason.AddressUnavailable => 0,
        _ => 1,
    };

    // Closing a socket causes a different error on every runtime, so the decisive fact is whether it was closed here.
    private LinkEnd FirstReason(LinkEnd end)
    {
        lock (_lock)
            return _closed ? LinkEnd.Requested : end;
    }

    private bool Adopt(Socket socket)
    {
        lock (_lock)
        {
            if (!_closed)
            {
                _socket = socket;
                return true;
            }
        }

        socket.Dispose();
        return false;
    }

    private LinkEnd Failed(SocketError error, Exception exception)
    {
        ConnectionReason reason = SocketErrors.ToReason(error);
        return new LinkEnd(reason, ConnectionMessages.TcpFailed(reason, options, exception));
    }
}
