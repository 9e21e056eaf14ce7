using System.Diagnostics;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Opens links one after the other for as long as the reader runs: connect, receive until the end, say why, wait, again.
internal sealed class ConnectionSupervisor(
    Func<Link> createLink,
    ReconnectPolicy policy,
    StatusBoard status,
    LinkActivity activity,
    Func<double> jitter)
{
    private volatile Link? _standing;

    // To the server, when a connection stands. Any thread.
    public bool TrySend(ReadOnlySpan<byte> bytes) => _standing?.TrySend(bytes) ?? false;

    // Completes with the status to end with, when stopped or, with reconnecting off, after the first link.
    public async Task<ConnectionStatus> RunAsync(IPacketReceiver receiver, CancellationToken stop)
    {
        int failures = 0;
        while (true)
        {
            (LinkEnd end, bool delivered) = await RunLinkAsync(receiver, failures + 1, stop).ConfigureAwait(false);

            // The first reason counts: a link that ended by itself, and would not have been tried again, was not ended by a later stop.
            if (end.Reason != ConnectionReason.Requested && (end.IsFinal || !policy.Enabled))
                return new ConnectionStatus(ConnectionState.Stopped, end.Reason, end.Message) { Attempt = failures + 1 };
            if (stop.IsCancellationRequested)
                return new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.Requested, LinkEnd.Requested.Message);

            failures = delivered ? 0 : failures + 1;
            TimeSpan delay = policy.GetDelay(failures, jitter());
            status.Set(new ConnectionStatus(ConnectionState.Waiting, end.Reason, end.Message) { Attempt = failures, RetryIn = delay });
            await CancellableDelay.WaitAsync(delay, stop).ConfigureAwait(false);
        }
    }

    // Delivered: whether frames came over the link.
    private async Task<(LinkEnd End, bool Delivered)> RunLinkAsync(IPacketReceiver receiver, int attempt, CancellationToken stop)
    {
        Link? link = null;
        ConnectionReason reason = ConnectionReason.NetworkError;
        try
        {
            link = createLink();
            using CancellationTokenRegistration closing = stop.Register(link.Close);
            status.Set(new ConnectionStatus(ConnectionState.Connecting, ConnectionReason.None, $"Connecting to {link.Target}.") { Attempt = attempt });
            (LinkEnd End, bool Delivered) result = await ReceiveAsync(link, receiver, attempt, stop).ConfigureAwait(false);
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
            _standing = null;
            receiver.Tap?.Close(reason.ToString(), Stopwatch.GetTimestamp());
            receiver.OnLinkClosed();
            link?.Dispose();
        }
    }

    private async Task<(LinkEnd End, bool Delivered)> ReceiveAsync(Link link, IPacketReceiver receiver, int attempt, CancellationToken stop)
    {
        LinkEnd end = await link.OpenAsync(stop).ConfigureAwait(false);
        if (end.Reason != ConnectionReason.None)
            return (end, false);

        _standing = link;
        activity.Begin(link.Target);
        receiver.OnLinkOpened();
        receiver.Tap?.Open(link.IsDatagrams, link.LocalEndPoint, link.RemoteEndPoint, Stopwatch.GetTimestamp());
        status.Set(new ConnectionStatus(ConnectionState.Connected, ConnectionReason.None, $"Connected to {link.Target}; waiting for frames.")
        {
            Attempt = attempt,
            LocalEndPoint = link.LocalEndPoint,
            RemoteEndPoint = link.RemoteEndPoint,
            ReceiveThread = link.ReceiveThread,
            ReceiveBufferSize = link.ReceiveBufferSize,
        });
        end = await link.ReceiveAsync(receiver).ConfigureAwait(false);
        return (activity.Explain(end), activity.HasPackets);
    }
}
