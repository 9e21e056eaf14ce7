using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// A TCP connection to a server that only sends (protocol.md section 4.1). How bytes are read differs by target: TcpReceiver.
internal sealed class TcpLink(LinkOptions options) : Link
{
    private readonly object _lock = new();
    private Socket? _socket;
    private bool _closed;

    public override string Target => options.Target;

    public override async Task<LinkEnd> OpenAsync(CancellationToken stop)
    {
        IPAddress[] addresses;
        try
        {
            addresses = await ResolveAsync(stop).ConfigureAwait(false);
        }
        catch (SocketException exception)
        {
            return Failed(exception.SocketErrorCode, exception);
        }

        if (addresses.Length == 0)
            return new LinkEnd(ConnectionReason.HostNotFound, Advice.HostNotFound(options.Host));

        LinkEnd last = LinkEnd.None;
        foreach (IPAddress address in addresses)
        {
            last = await ConnectAsync(address, stop).ConfigureAwait(false);
            if (last.Reason == ConnectionReason.None || stop.IsCancellationRequested)
                break;
        }

        return last;
    }

    public override async Task<LinkEnd> ReceiveAsync(IPacketReceiver receiver)
    {
        var assembler = new PacketAssembler(new PacketScanner(options.MaxValues), receiver);
        try
        {
            await TcpReceiver.ReceiveAsync(_socket!, assembler).ConfigureAwait(false);
            return new LinkEnd(ConnectionReason.ClosedByPeer, Advice.ClosedByPeer(Target));
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            SocketError error = SocketErrors.Find(exception)?.SocketErrorCode ?? SocketError.OperationAborted;
            return Failed(error, exception);
        }
        finally
        {
            assembler.Abandon();
        }
    }

    public override void Close()
    {
        lock (_lock)
        {
            _closed = true;
            _socket?.Dispose();
        }
    }

    // A name that takes longer than a connection may is abandoned: no runtime can interrupt the system's resolver.
    private async Task<IPAddress[]> ResolveAsync(CancellationToken stop)
    {
        if (IPAddress.TryParse(options.Host, out IPAddress? address))
            return [address];

        Task<IPAddress[]> resolving = options.Resolve(options.Host);
        Task first = await Task.WhenAny(resolving, Task.Delay(options.ConnectTimeout, stop)).ConfigureAwait(false);
        return first == resolving ? await resolving.ConfigureAwait(false) : throw new SocketException((int)SocketError.HostNotFound);
    }

    private async Task<LinkEnd> ConnectAsync(IPAddress address, CancellationToken stop)
    {
        var socket = new Socket(address.AddressFamily, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        if (!Adopt(socket))
            return LinkEnd.None;

        using var timeout = CancellationTokenSource.CreateLinkedTokenSource(stop);
        timeout.CancelAfter(options.ConnectTimeout);
        try
        {
            using (timeout.Token.Register(socket.Dispose))
            {
                if (options.LocalAddress is { } local)
                    socket.Bind(new IPEndPoint(local, 0));

                await TcpConnector.ConnectAsync(socket, new IPEndPoint(address, options.Port)).ConfigureAwait(false);
            }

            LocalEndPoint = socket.LocalEndPoint;
            RemoteEndPoint = socket.RemoteEndPoint;
            return LinkEnd.None;
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            socket.Dispose();
            return timeout.IsCancellationRequested
                ? Failed(SocketError.TimedOut, exception)
                : Failed(SocketErrors.Find(exception)?.SocketErrorCode ?? SocketError.SocketError, exception);
        }
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
        return new LinkEnd(reason, Advice.TcpFailed(reason, options, exception));
    }
}
