using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// One stream of a source. Streams and sources are code of the application, or of others: any call may block, throw, or ignore a cancellation. No call
// delays the end of the link for long.
internal sealed class SourceLink(ByteSource source, string name, LinkOptions options) : Link
{
    private readonly object _lock = new();
    private readonly ReceiveGate _gate = new();

    // Never disposed: it has no timer, and the source may still check it.
    private readonly CancellationTokenSource _closeSource = new();
    private readonly TaskCompletionSource<bool> _closed = new();
    private ByteReceiver? _receiver;
    private bool _isClosed;

    public override ReceiveThread ReceiveThread => _receiver?.Thread ?? ReceiveThread.Auto;

    public override string Target => name;

    public override async Task<LinkEnd> OpenAsync(CancellationToken cancellationToken)
    {
        Task opening = OpenAsync();
        try
        {
            await _gate.UntilClosedAsync(opening).ConfigureAwait(false);
            return IsClosed ? LinkEnd.Requested : LinkEnd.None;
        }
        catch (Exception exception)
        {
            return IsClosed ? LinkEnd.Requested : Failed(exception, ConnectionMessages.NotOpened(Target, exception));
        }
    }

    public override async Task<LinkEnd> ReceiveAsync(IPacketReceiver receiver, ILinkListener? listener)
    {
        var assembler = new PacketAssembler(new PacketScanner(options.MaxValues), receiver, listener?.Tap);
        try
        {
            await _gate.UntilClosedAsync(_receiver!.ReceiveAsync(assembler, _gate)).ConfigureAwait(false);
        }
        catch (OperationCanceledException) when (IsClosed)
        {
            // The read has not ended.
        }
        finally
        {
            assembler.Abandon();
        }

        if (IsClosed)
        {
            // The read can end before the stream is disposed.
            await _closed.Task.ConfigureAwait(false);
            return LinkEnd.Requested;
        }

        return _receiver!.Failure is { } failure
            ? Failed(failure, ConnectionMessages.ReceivingFailed(Target, failure))
            : new LinkEnd(ConnectionReason.ClosedByPeer, ConnectionMessages.EndOfBytes(Target)) { IsFinal = !source.CanReopen };
    }

    public override void Close()
    {
        lock (_lock)
        {
            if (_isClosed)
                return;

            _isClosed = true;
        }

        try
        {
            DedicatedThread.RunAsync("NeuronMocap stream close", CloseSource, TaskCreationOptions.None).Wait(options.CloseTimeout);
        }
        finally
        {
            _gate.Close();
            _closed.TrySetResult(true);
        }
    }

    private bool IsClosed
    {
        get
        {
            lock (_lock)
                return _isClosed;
        }
    }

    private async Task OpenAsync()
    {
        ValueTask<ByteReceiver> opening = default;
        await DedicatedThread.RunAsync(
            "NeuronMocap stream open",
            () => opening = source.OpenReceiverAsync(options.ReceiveThread, _closeSource.Token),
            TaskCreationOptions.None).ConfigureAwait(false);
        ByteReceiver receiver = await opening.ConfigureAwait(false);
        if (!TryAdopt(receiver))
            CloseQuietly(receiver.Close);
    }

    private bool TryAdopt(ByteReceiver receiver)
    {
        lock (_lock)
        {
            if (!_isClosed)
                _receiver = receiver;

            return !_isClosed;
        }
    }

    private void CloseSource()
    {
        CloseQuietly(_closeSource.Cancel);
        if (_receiver is { } receiver)
            CloseQuietly(receiver.Close);
    }

    internal static void CloseQuietly(Action close)
    {
        try
        {
            close();
        }
        catch (Exception)
        {
            // What the source does at its end no longer matters to the reader.
        }
    }

    private LinkEnd Failed(Exception exception, string message)
    {
        ConnectionReason reason = exception switch
        {
            NeuronConnectionException connection => connection.Reason,
            SocketException socket => SocketErrors.ToReason(socket.SocketErrorCode),
            IOException { InnerException: SocketException socket } => SocketErrors.ToReason(socket.SocketErrorCode),
            UnauthorizedAccessException => ConnectionReason.AccessDenied,
            TimeoutException => ConnectionReason.TimedOut,
            _ => ConnectionReason.NetworkError,
        };
        return new LinkEnd(reason is ConnectionReason.None or ConnectionReason.Requested ? ConnectionReason.NetworkError : reason, message) { IsFinal = !source.CanReopen };
    }
}
