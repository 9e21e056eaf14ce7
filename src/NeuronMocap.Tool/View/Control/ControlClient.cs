using System.Net.WebSockets;
using System.Text.Json;
using System.Threading.Channels;
using Microsoft.AspNetCore.Http;
using NeuronMocap.AspNetCore;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Control;

/// <summary>One page: a loop that sends its messages, and a loop that answers its pings.</summary>
internal sealed class ControlClient(WebSocket socket, LimitedInput input, HttpContext context)
{
    public const string Stopping = "The server stops.";

    // Minutes of the usual messages. Whoever is further behind gets everything anew after it has connected again.
    private const int MostWaiting = 1024;
    private const int LargestMessage = 4096;

    private static readonly TimeSpan SendTimeout = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan CloseTimeout = TimeSpan.FromSeconds(2);

    private readonly Channel<byte[]> _waiting = Channel.CreateBounded<byte[]>(new BoundedChannelOptions(MostWaiting) { SingleReader = true });
    private (WebSocketCloseStatus Status, string Reason)? _end;

    /// <summary>Adds a message, which is not changed any more. Any thread.</summary>
    public void Put(byte[] message)
    {
        if (!_waiting.Writer.TryWrite(message))
            End(WebSocketCloseStatus.PolicyViolation, "The page does not read its messages.");
    }

    /// <summary>Ends the connection after the messages that wait. Any thread; the first reason counts.</summary>
    public void End(WebSocketCloseStatus status, string reason)
    {
        _end ??= (status, reason);
        _waiting.Writer.TryComplete();
    }

    /// <summary>Serves the page until one side ends the connection. Never throws.</summary>
    public async Task RunAsync()
    {
        input.Exceeded = () => End(WebSocketCloseStatus.PolicyViolation, $"A page sends at most {LimitedInput.MostBytes} bytes in a second.");
        Task reading = ReadAsync();
        try
        {
            await foreach (byte[] message in _waiting.Reader.ReadAllAsync())
            {
                using var timeoutSource = new CancellationTokenSource(SendTimeout);
                await socket.SendAsync(message, WebSocketMessageType.Text, endOfMessage: true, timeoutSource.Token);
            }

            await CloseAsync();
            await Task.WhenAny(reading, Task.Delay(CloseTimeout));
        }
        catch (Exception exception) when (IsEndOfConnection(exception))
        {
            // The page is gone, or does not read.
            context.Abort();
        }

        _waiting.Writer.TryComplete();
        input.End();
        await reading;
    }

    private async Task CloseAsync()
    {
        if (_end is not var (status, reason) || socket.State is not (WebSocketState.Open or WebSocketState.CloseReceived))
            return;

        using var timeoutSource = new CancellationTokenSource(CloseTimeout);
        await socket.CloseOutputAsync(status, reason, timeoutSource.Token);
    }

    private async Task ReadAsync()
    {
        byte[] buffer = new byte[LargestMessage];
        int length = 0;
        try
        {
            while (true)
            {
                ValueWebSocketReceiveResult result = await socket.ReceiveAsync(buffer.AsMemory(length), CancellationToken.None);
                if (result.MessageType == WebSocketMessageType.Close)
                    break;

                length += result.Count;
                if (!result.EndOfMessage && length == buffer.Length)
                {
                    End(WebSocketCloseStatus.MessageTooBig, $"A message of a page has at most {LargestMessage} bytes.");
                    return;
                }

                if (!result.EndOfMessage)
                    continue;

                Answer(buffer.AsSpan(0, length));
                length = 0;
            }

            End(WebSocketCloseStatus.NormalClosure, string.Empty);
        }
        catch (Exception exception) when (IsEndOfConnection(exception))
        {
            End(WebSocketCloseStatus.NormalClosure, string.Empty);
        }
    }

    // Only a ping needs an answer. Unknown messages may come from a newer page.
    private void Answer(ReadOnlySpan<byte> message)
    {
        try
        {
            if (JsonSerializer.Deserialize<PingJson>(message, ApiJson.Options) is { Type: "ping" } ping)
                Put(ApiJson.ToBytes(new PongJson("pong", ping.T, (DateTime.UtcNow - DateTime.UnixEpoch).TotalMilliseconds)));
        }
        catch (JsonException)
        {
            End(WebSocketCloseStatus.InvalidPayloadData, "A message of a page is a JSON object.");
        }
    }

    private static bool IsEndOfConnection(Exception exception) =>
        exception is WebSocketException or IOException or OperationCanceledException or ObjectDisposedException or InvalidOperationException;

    private sealed record PingJson(string? Type, double? T);

    // The time is that of this computer, so that the page can tell how old a pose is.
    private sealed record PongJson(string Type, double? T, double Time);
}
