using System.Diagnostics;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Opens links one after the other for as long as the reader runs: connect, receive until the end, say why, wait, again.
internal sealed class ConnectionSupervisor(
    Func<Link> createLink,
    ReconnectPolicy policy,
    StatusPublisher status,
    LinkActivity activity,
    Func<double> jitter)
{
    private volatile Link? _connectedLink;

    // To the server, when a connection stands. Any thread.
    public bool TrySend(ReadOnlySpan<byte> bytes) => _connectedLink?.TrySend(bytes) ?? false;

    // Completes with the status to end with, when stopped or, with reconnecting off, after the first link.
    public async Task<ConnectionStatus> RunAsync(IPacketReceiver receiver, ILinkListener listener, CancellationToken cancellationToken)
    {
        int failures = 0;
        while (true)
        {
            (LinkEnd end, bool delivered) = await RunLinkAsync(receiver, listener, failures + 1, cancellationToken).ConfigureAwait(false);

            // The first reason counts: a link that ended by itself, and would not have been tried again, was not ended by a later stop.
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

    // Delivered: whether frames came over the link.
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
            // Out of memory, or a fault of ours: neither may end the reader, or the process, while there is a next attempt.
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
