using System.Buffers;
using System.IO.Pipelines;
using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Connections;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.AspNetCore.Connections;

/// <summary>A connection that Kestrel accepted, perhaps with TLS in front of it.</summary>
/// <remarks>
/// The session's thread blocks here while the client does not read, as it does with a socket. Kestrel closes the connection when its handler has returned,
/// so ending it here only ends the waits.
/// </remarks>
internal sealed class PipeTransport(ConnectionContext connection, TimeSpan sendTimeout) : ClientTransport
{
    private readonly PipeReader _input = connection.Transport.Input;
    private readonly PipeWriter _output = connection.Transport.Output;
    private volatile bool _isEnded;

    public override EndPoint? RemoteEndPoint => connection.RemoteEndPoint;

    public override bool IsLeft => _isEnded || connection.ConnectionClosed.IsCancellationRequested;

    public override SocketError TrySend(byte[] buffer, int offset, int count, out int sent)
    {
        sent = 0;
        if (_isEnded)
            return SocketError.OperationAborted;

        try
        {
            _output.Write(buffer.AsSpan(offset, count));
            ValueTask<FlushResult> flushing = _output.FlushAsync();
            if (!TryWait(flushing, out FlushResult result))
                return SocketError.TimedOut;
            if (result.IsCanceled || result.IsCompleted)
                return SocketError.ConnectionReset;

            sent = count;
            return SocketError.Success;
        }
        catch (Exception exception) when (IsEndOfConnection(exception))
        {
            return SocketError.ConnectionReset;
        }
    }

    public override async ValueTask<int> ReceiveAsync(Memory<byte> room)
    {
        try
        {
            while (!_isEnded)
            {
                ReadResult result = await _input.ReadAsync().ConfigureAwait(false);
                if (result.IsCanceled)
                    break;

                int count = (int)Math.Min(room.Length, result.Buffer.Length);
                ReadOnlySequence<byte> taken = result.Buffer.Slice(0, count);
                taken.CopyTo(room.Span);
                _input.AdvanceTo(taken.End);
                if (count > 0 || result.IsCompleted)
                    return count;
            }
        }
        catch (Exception exception) when (IsEndOfConnection(exception))
        {
            // The client is gone, or Kestrel has closed the connection.
        }

        return 0;
    }

    public override int Receive(ArraySegment<byte> room, int timeout)
    {
        ValueTask<int> receiving = ReceiveAsync(room);
        if (receiving.IsCompletedSuccessfully)
            return receiving.Result;

        Task<int> waiting = receiving.AsTask();
        return waiting.Wait(timeout == 0 ? Timeout.Infinite : timeout) ? waiting.Result : throw new SocketException((int)SocketError.TimedOut);
    }

    // Kestrel sends what is left and then the end, when the handler has returned. Nothing that the client sends matters any more.
    public override void EndSending() => Dispose();

    public override void DropUnsent() => connection.Abort(new ConnectionAbortedException("The client did not read."));

    public override void Dispose()
    {
        _isEnded = true;
        _input.CancelPendingRead();
        _output.CancelPendingFlush();
    }

    private bool TryWait(ValueTask<FlushResult> flushing, out FlushResult result)
    {
        if (flushing.IsCompleted)
        {
            result = flushing.GetAwaiter().GetResult();
            return true;
        }

        // The result itself, and not an AggregateException.
        Task<FlushResult> waiting = flushing.AsTask();
        bool hasEnded = Task.WaitAny([waiting], sendTimeout) == 0;
        result = hasEnded ? waiting.GetAwaiter().GetResult() : default;
        return hasEnded;
    }

    // Reset, aborted, or completed by Kestrel.
    private static bool IsEndOfConnection(Exception exception) => exception is IOException or OperationCanceledException or InvalidOperationException or ObjectDisposedException;
}
