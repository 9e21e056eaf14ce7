using System.Diagnostics;
using System.Net;
using System.Net.WebSockets;
using System.Threading.Channels;
using Microsoft.AspNetCore.Connections.Features;
using Microsoft.AspNetCore.Http;

namespace NeuronMocap.AspNetCore;

/// <summary>One client: a loop that sends its newest messages, and a loop that reads what it sends, which nobody needs.</summary>
internal sealed class WebSocketClient(WebSocket socket, LimitedInput input, WebSocketRequest request, HttpContext context)
{
    // Half a second at 120 Hz: packets are often recorded or relayed. Whoever draws wants the newest frame.
    private const int PacketsThatWait = 64;
    private const int ViewsThatWait = 8;

    private const int LargestMessage = 4096;
    private const int MostMessages = 100;

    private static readonly TimeSpan CloseTimeout = TimeSpan.FromSeconds(2);

    // Kestrel still has to send what is left.
    private static readonly TimeSpan AbortTimeout = TimeSpan.FromSeconds(5);

    private readonly Mailbox _mailbox = new(request.Form == WebSocketForm.Packet ? PacketsThatWait : ViewsThatWait, request.MaxRate);

    // One place: the loop takes all messages at each wake-up. It is the only reader, so waiting allocates nothing.
    private readonly Channel<bool> _wakeUp = Channel.CreateBounded<bool>(new BoundedChannelOptions(1) { FullMode = BoundedChannelFullMode.DropWrite, SingleReader = true });
    private readonly EndPoint? _remoteEndPoint = context.Connection.RemoteIpAddress is { } address ? new IPEndPoint(address, context.Connection.RemotePort) : null;
    private (WebSocketCloseStatus Status, string Reason)? _end;
    private long _sent;
    private long _bytes;
    private long _sendingSince;
    private long _endedAt;

    public WebSocketForm Form => request.Form;

    public WebSocketClientStatistics Statistics => new()
    {
        RemoteEndPoint = _remoteEndPoint,
        Form = request.Form,
        MaxRate = request.MaxRate,
        FramesSent = Interlocked.Read(ref _sent),
        FramesDropped = _mailbox.Dropped,
        FramesSkipped = _mailbox.Skipped,
        BytesSent = Interlocked.Read(ref _bytes),
    };

    /// <summary>Adds a message. The client takes a reference of its own.</summary>
    public void Put(MotionMessage message)
    {
        if (_mailbox.Put(message))
            _wakeUp.Writer.TryWrite(true);
    }

    /// <summary>Ends the connection after the messages that wait. Any thread; the first reason counts.</summary>
    public void End(WebSocketCloseStatus status, string reason)
    {
        if (Interlocked.CompareExchange(ref _endedAt, Stopwatch.GetTimestamp(), 0) != 0)
            return;

        _end = (status, reason);
        _wakeUp.Writer.TryComplete();
    }

    /// <summary>Ends the connection if a message has waited too long for the client to read. After <see cref="End"/>, all messages together have a short time.</summary>
    /// <param name="timeout">The longest wait.</param>
    public void AbortIfStuck(TimeSpan timeout)
    {
        long since = Interlocked.Read(ref _sendingSince);
        long ended = Interlocked.Read(ref _endedAt);
        if (since != 0 && (Stopwatch.GetElapsedTime(since) > timeout || (ended != 0 && Stopwatch.GetElapsedTime(ended) > CloseTimeout)))
            context.Abort();
    }

    /// <summary>Serves the client until one side ends the connection. Never throws.</summary>
    public async Task RunAsync()
    {
        input.Exceeded = () => End(WebSocketCloseStatus.PolicyViolation, $"A client sends at most {LimitedInput.MostBytes} bytes in a second.");
        Task reading = ReadAsync();
        try
        {
            await SendAllAsync().ConfigureAwait(false);
            await CloseAsync().ConfigureAwait(false);
            await Task.WhenAny(reading, Task.Delay(CloseTimeout)).ConfigureAwait(false);
        }
        catch (Exception exception) when (IsEndOfConnection(exception))
        {
            // The client is gone, or did not read.
        }
        finally
        {
            _mailbox.Close();

            // Without the client's half of the handshake, Kestrel closes the connection. The client gets what was sent before.
            if (!reading.IsCompleted)
            {
                if (HttpProtocol.IsHttp11(context.Request.Protocol))
                    _ = AbortLaterAsync(context.Features.Get<IConnectionLifetimeFeature>());

                input.End();
            }

            await reading.ConfigureAwait(false);
        }
    }

    // Only with HTTP/1.1: a connection of HTTP/2 serves other requests, too.
    private static async Task AbortLaterAsync(IConnectionLifetimeFeature? connection)
    {
        if (connection is null)
            return;

        await Task.Delay(AbortTimeout).ConfigureAwait(false);
        connection.Abort();
    }

    private async Task SendAllAsync()
    {
        while (await _wakeUp.Reader.WaitToReadAsync().ConfigureAwait(false))
        {
            _wakeUp.Reader.TryRead(out _);
            await SendWaitingAsync().ConfigureAwait(false);
        }

        await SendWaitingAsync().ConfigureAwait(false);
    }

    private async ValueTask SendWaitingAsync()
    {
        while (_mailbox.TryTake(out MotionMessage? message, out byte[]? skeleton))
        {
            bool isSent = false;
            try
            {
                if (skeleton is not null)
                    await SendAsync(skeleton, message!.Type).ConfigureAwait(false);

                await SendAsync(message!.Bytes, message.Type).ConfigureAwait(false);
                isSent = true;
                Interlocked.Increment(ref _sent);
            }
            finally
            {
                if (!isSent)
                    _mailbox.CountUnsent();

                message!.Release();
            }
        }
    }

    // A send has no token, which would allocate at each message. AbortIfStuck limits it.
    private async ValueTask SendAsync(ReadOnlyMemory<byte> bytes, WebSocketMessageType type)
    {
        ValueTask sending = socket.SendAsync(bytes, type, endOfMessage: true, CancellationToken.None);
        if (!sending.IsCompleted)
            Interlocked.Exchange(ref _sendingSince, Stopwatch.GetTimestamp());

        await sending.ConfigureAwait(false);
        Interlocked.Exchange(ref _sendingSince, 0);
        Interlocked.Add(ref _bytes, bytes.Length);
    }

    private async Task CloseAsync()
    {
        if (_end is not { } end || socket.State is not (WebSocketState.Open or WebSocketState.CloseReceived))
            return;

        Interlocked.Exchange(ref _sendingSince, Stopwatch.GetTimestamp());
        await socket.CloseOutputAsync(end.Status, end.Reason, CancellationToken.None).ConfigureAwait(false);
        Interlocked.Exchange(ref _sendingSince, 0);
    }

    // Reads until the client closes or misbehaves. Pings are answered inside. A fragment counts as a message, because it can be empty.
    private async Task ReadAsync()
    {
        byte[] buffer = new byte[LargestMessage];
        int length = 0;
        int parts = 0;
        long second = Stopwatch.GetTimestamp();
        try
        {
            while (true)
            {
                ValueWebSocketReceiveResult result = await socket.ReceiveAsync(buffer.AsMemory(), CancellationToken.None).ConfigureAwait(false);
                if (result.MessageType == WebSocketMessageType.Close)
                {
                    End(WebSocketCloseStatus.NormalClosure, string.Empty);
                    return;
                }

                length += result.Count;
                if (length > LargestMessage)
                    End(WebSocketCloseStatus.MessageTooBig, $"A message of a client has at most {LargestMessage} bytes.");
                if (result.EndOfMessage)
                    length = 0;
                if (Stopwatch.GetElapsedTime(second) > TimeSpan.FromSeconds(1))
                    (second, parts) = (Stopwatch.GetTimestamp(), 0);
                if (++parts > MostMessages)
                    End(WebSocketCloseStatus.PolicyViolation, $"A client sends at most {MostMessages} messages in a second.");
            }
        }
        catch (Exception exception) when (IsEndOfConnection(exception))
        {
            End(WebSocketCloseStatus.NormalClosure, string.Empty);
        }
    }

    private static bool IsEndOfConnection(Exception exception) => exception is WebSocketException or IOException or OperationCanceledException or ObjectDisposedException or InvalidOperationException;
}
