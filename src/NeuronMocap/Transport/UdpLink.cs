using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// A UDP port to which any computer can send (protocol.md section 4.2).
internal sealed class UdpLink(
    LinkOptions options, SenderFilter filter, UdpServers? servers = null, object? receiveLock = null, ReceiveThreads? threads = null) : Link
{
    private readonly ReceiveThreads _threads = threads ?? ReceiveThreads.Shared;
    private readonly object _lock = new();
    private readonly ReceiveGate _gate = new();
    private Socket? _socket;
    private bool _closed;

    public override bool IsDatagrams => true;

    public override ReceiveThread ReceiveThread { get; } =
        UdpReceiver.HasThreads && (threads ?? ReceiveThreads.Shared).TryTake(options.ReceiveThread) ? ReceiveThread.Dedicated : ReceiveThread.Pool;

    public override string Target => $"UDP port {(LocalEndPoint as IPEndPoint)?.Port ?? options.Port}";

    public override Task<LinkEnd> OpenAsync(CancellationToken cancellationToken) => Task.FromResult(Bind());

    public override async Task<LinkEnd> ReceiveAsync(IPacketReceiver receiver, ILinkListener? listener)
    {
        var senders = new UdpSenders(new PacketScanner(options.MaxValues), receiver, filter, servers, receiveLock, listener?.Tap);
        using var settling = new UdpPendingTimer(senders, _gate);
        try
        {
            await UdpReceiver.ReceiveAsync(_socket!, senders, _gate, ReceiveThread).ConfigureAwait(false);
            return LinkEnd.None;
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            return IsClosed ? LinkEnd.Requested : Failed(exception);
        }
    }

    private bool IsClosed
    {
        get
        {
            lock (_lock)
                return _closed;
        }
    }

    public override void Close()
    {
        lock (_lock)
        {
            if (!_closed && ReceiveThread == ReceiveThread.Dedicated)
                _threads.Return();

            _closed = true;
            _socket?.Dispose();
        }

        _gate.Close();
    }

    private LinkEnd Bind()
    {
        lock (_lock)
        {
            if (_closed)
                return LinkEnd.Requested;

            try
            {
                _socket = UdpSocket.Open(options);
                LocalEndPoint = _socket.LocalEndPoint;
                ReceiveBufferSize = UdpSocket.ReadBuffer(_socket);
                return LinkEnd.None;
            }
            catch (SocketException exception)
            {
                return Failed(exception);
            }
        }
    }

    private LinkEnd Failed(Exception exception)
    {
        ConnectionReason reason = SocketErrors.ToReason((exception as SocketException)?.SocketErrorCode ?? SocketError.OperationAborted);
        return new LinkEnd(reason, ConnectionMessages.UdpFailed(reason, options, exception));
    }
}
