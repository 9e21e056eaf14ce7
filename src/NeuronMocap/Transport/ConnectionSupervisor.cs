using System.Diagnostics;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Opens one link after another while the reader runs: connect, receive until the end, report why, wait, and start again.
internal sealed class ConnectionSupervisor(
    Func<Link> createLink,
    ReconnectPolicy policy,
    StatusPublisher status,
    LinkActivity activity,
    Func<double> jitter)
{
    private volatile Link? _connectedLink;

    // Sends bytes to the server if there is a connection. Any thread.
    public bool TrySend(ReadOnlySpan<byte> bytes) => _connectedLink?.TrySend(bytes) ?? false;

    // Completes with the final status: when the reader is stopped or, if reconnecting is off, after the first link.
    public async Task<ConnectionStatus> RunAsync(IPacketReceiver receiver, ILinkListener listener, CancellationToken cancellationToken)
    {
        int failures = 0;
        while (true)
        {
            (LinkEnd end, bool delivered) = await RunLinkAsync(receiver, listener, failures + 1, cancellationToken).ConfigureAwait(false);

            // If a link ended without a request and no retry would follow, a later stop does not replace the first reason.
            if (end.Reason != ConnectionReason.Requested && (end.IsFinal || !policy.Enabled))
                return new ConnectionStatus(ConnectionState.Stopped, end.Reason, end.Message) { Attempt = failures + 1 };
            if (cancellationToken.IsCancellationRequested)
                return new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.Requested, LinkEnd.Requested.Message);

            failures = delivered ? 0 : failures + 1;
            TimeSpan delay = policy.GetDelay(failures, jitter());
            status.Set(new ConnectionStatus(ConnectionState.Waiting, end.Reason, end.Message) { Attempt = failures, RetryIn = delay });
            await CancellableDelay.WaitAsync(delay, cancellationToken).ConfigureAwait(false);
        }
    }

    // Delivered: whether the link brought frames.
    private async Task<(LinkEnd End, bool Delivered)> RunLinkAsync(
        IPacketReceiver receiver, ILinkListener listener, int attempt, CancellationToken cancellationToken)
    {
        Link? link = null;
        ConnectionReason reason = ConnectionReason.NetworkError;
        try
        {
            link = createLink();
            using CancellationTokenRegistration closing = cancellationToken.Register(link.Close);
            status.Set(new ConnectionStatus(ConnectionState.Connecting, ConnectionReason.None, $"Connecting to {link.Target}.") { Attempt = attempt });
            (LinkEnd End, bool Delivered) result = await ReceiveAsync(link, receiver, listener, attempt, cancellationToken).ConfigureAwait(false);
            reason = result.End.Reason;
            return result;
        }
        catch (Exception exception)
        {
            // The system is out of memory, or the library has a bug. Neither may end the reader or the process while another attempt is possible.
            return (new LinkEnd(ConnectionReason.NetworkError, ConnectionMessages.Failed(link?.Target ?? "the server", exception)), false);
        }
        finally
        {
            _connectedLink = null;
            listener.Tap?.Close(reason.ToString(), Stopwatch.GetTimestamp());
            listener.OnLinkClosed();
            link?.Dispose();
        }
    }

    private async Task<(LinkEnd End, bool Delivered)> ReceiveAsync(
        Link link, IPacketReceiver receiver, ILinkListener listener, int attempt, CancellationToken cancellationToken)
    {
        LinkEnd end = await link.OpenAsync(cancellationToken).ConfigureAwait(false);
        if (end.Reason != ConnectionReason.None)
            return (end, false);

        _connectedLink = link;
        activity.Begin(link.Target);
        listener.OnLinkOpened();
        listener.Tap?.Open(link.IsDatagrams, link.LocalEndPoint, link.RemoteEndPoint, Stopwatch.GetTimestamp());
        status.Set(new ConnectionStatus(ConnectionState.Connected, ConnectionReason.None, $"Connected to {link.Target}; waiting for frames.")
        {
            Attempt = attempt,
            LocalEndPoint = link.LocalEndPoint,
            RemoteEndPoint = link.RemoteEndPoint,
            ReceiveThread = link.ReceiveThread,
            ReceiveBufferSize = link.ReceiveBufferSize,
        });
        end = await link.ReceiveAsync(receiver, listener).ConfigureAwait(false);
        return (activity.Explain(end), activity.HasPackets);
    }
}
