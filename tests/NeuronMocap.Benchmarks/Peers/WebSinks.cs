using System.Diagnostics;
using System.Globalization;
using System.Net.WebSockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Benchmarks.Peers;

// WebSocket clients, in their own process. One more receives packets, and measures how old they are. Prints the port when all are connected, and at the end
// the median and the 99th percentile in microseconds.
internal static class WebSinks
{
    public static async Task RunAsync(int port, int connections, string form)
    {
        var delays = new List<double>();
        List<Task> reading = [ReadAsync(await ConnectAsync(port, "packet"), packet =>
            delays.Add(Stopwatch.GetElapsedTime(TestFrame.GetTime(packet[TestFrame.HeaderSize..])).TotalMicroseconds))];
        for (int i = 0; i < connections; i++)
            reading.Add(ReadAsync(await ConnectAsync(port, form), static _ => { }));

        Console.WriteLine(port);
        await Task.WhenAll(reading);
        delays.Sort();
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{delays[delays.Count / 2]} {delays[delays.Count * 99 / 100]}"));
    }

    private static async Task<ClientWebSocket> ConnectAsync(int port, string form)
    {
        var socket = new ClientWebSocket();
        socket.Options.AddSubProtocol(form);
        await socket.ConnectAsync(new Uri($"ws://127.0.0.1:{port}"), CancellationToken.None);
        return socket;
    }

    private delegate void Take(ReadOnlySpan<byte> message);

    private static async Task ReadAsync(ClientWebSocket socket, Take take)
    {
        byte[] buffer = new byte[64 * 1024];
        int length = 0;
        while (true)
        {
            ValueWebSocketReceiveResult result = await socket.ReceiveAsync(buffer.AsMemory(length), CancellationToken.None);
            if (result.MessageType == WebSocketMessageType.Close)
                break;

            length += result.Count;
            if (!result.EndOfMessage)
                continue;

            if (length >= ProtocolConstants.HeaderSize)
                take(buffer.AsSpan(0, length));

            length = 0;
        }

        await socket.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, null, CancellationToken.None);
        socket.Dispose();
    }
}
