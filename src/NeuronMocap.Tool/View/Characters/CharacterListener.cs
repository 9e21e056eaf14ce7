using System.Net.WebSockets;
using System.Threading.Channels;
using Microsoft.AspNetCore.Http;
using NeuronMocap.AspNetCore;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>A page that shows a character: a loop that sends the newest pose. A pose that waits is replaced by the next one.</summary>
internal sealed class CharacterListener(WebSocket socket, LimitedInput input, HttpContext context)
{
    private static readonly TimeSpan SendTimeout = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan CloseTimeout = TimeSpan.FromSeconds(2);

    private readonly Lock _lock = new();
    private readonly Channel<bool> _signal = Channel.CreateBounded<bool>(new BoundedChannelOptions(1) { FullMode = BoundedChannelFullMode.DropWrite });
    private readonly byte[] _waiting = new byte[CharacterPose.MaxSize];
    private readonly byte[] _sending = new byte[CharacterPose.MaxSize];
    private int _size;
    private (WebSocketCloseStatus Status, string Reason)? _end;

    /// <summary>Replaces the pose that waits. Any thread.</summary>
    public void Put(ReadOnlySpan<byte> pose)
    {
        lock (_lock)
        {
            pose.CopyTo(_waiting);
            _size = pose.Length;
            _signal.Writer.TryWrite(true);
        }
    }

    /// <summary>Ends the connection. Any thread; the first reason counts.</summary>
    public void End(WebSocketCloseStatus status, string reason)
    {
        lock (_lock)
        {
            if (_end is not null)
                return;

            _end = (status, reason);
            _signal.Writer.TryWrite(true);
        }
    }

    /// <summary>Serves the page until one side ends the connection. Never throws.</summary>
    public async Task RunAsync()
    {
        input.Exceeded = () => End(WebSocketCloseStatus.PolicyViolation, $"A page sends at most {LimitedInput.MostBytes} bytes in a second.");
        Task reading = ReadAsync();
        using var timeoutSource = new CancellationTokenSource();
        try
        {
            while (await TakeAsync() is > 0 and var size)
            {
                timeoutSource.CancelAfter(SendTimeout);
                await socket.SendAsync(_sending.AsMemory(0, size), WebSocketMessageType.Binary, endOfMessage: true, timeoutSource.Token);
                timeoutSource.CancelAfter(Timeout.InfiniteTimeSpan);
            }

            await CloseAsync();
            await Task.WhenAny(reading, Task.Delay(CloseTimeout));
        }
        catch (Exception exception) when (IsEndOfConnection(exception))
        {
            // The page is gone, or does not read.
            context.Abort();
        }

        input.End();
        await reading;
    }

    // Returns 0 at the end.
    private async Task<int> TakeAsync()
    {
        while (true)
        {
            await _signal.Reader.ReadAsync();
            lock (_lock)
            {
                if (_end is not null)
                    return 0;
                if (_size == 0)
                    continue;

                int size = _size;
                _waiting.AsSpan(0, size).CopyTo(_sending);
                _size = 0;
                return size;
            }
        }
    }

    private async Task CloseAsync()
    {
        if (_end is not var (status, reason) || socket.State is not (WebSocketState.Open or WebSocketState.CloseReceived))
            return;

        using var timeoutSource = new CancellationTokenSource(CloseTimeout);
        await socket.CloseOutputAsync(status, reason, timeoutSource.Token);
    }

    // A page sends nothing but its end.
    private async Task ReadAsync()
    {
        byte[] buffer = new byte[64];
        try
        {
            while ((await socket.ReceiveAsync(buffer.AsMemory(), CancellationToken.None)).MessageType != WebSocketMessageType.Close)
            {
            }
        }
        catch (Exception exception) when (IsEndOfConnection(exception))
        {
            // The page is gone.
        }

        End(WebSocketCloseStatus.NormalClosure, string.Empty);
    }

    private static bool IsEndOfConnection(Exception exception) =>
        exception is WebSocketException or IOException or OperationCanceledException or ObjectDisposedException or InvalidOperationException;
}
