using System.Net.WebSockets;
using System.Text.Json;

namespace NeuronMocap.AspNetCore.Tests.Infrastructure;

internal static class WebSocketExtensions
{
    public static async Task<(WebSocketMessageType Type, byte[] Bytes)> ReadAsync(this WebSocket socket)
    {
        byte[] buffer = new byte[64 * 1024];
        int length = 0;
        while (true)
        {
            WebSocketReceiveResult result = await socket.ReceiveAsync(new ArraySegment<byte>(buffer, length, buffer.Length - length), TestContext.Current.CancellationToken).Soon();
            length += result.Count;
            if (result.EndOfMessage)
                return (result.MessageType, buffer[..length]);
        }
    }

    public static async Task<JsonElement> ReadJsonAsync(this WebSocket socket)
    {
        (WebSocketMessageType type, byte[] bytes) = await socket.ReadAsync();
        Assert.Equal(WebSocketMessageType.Text, type);
        return JsonDocument.Parse(bytes).RootElement;
    }

    public static async Task<byte[]> ReadBinaryAsync(this WebSocket socket)
    {
        (WebSocketMessageType type, byte[] bytes) = await socket.ReadAsync();
        Assert.Equal(WebSocketMessageType.Binary, type);
        return bytes;
    }

    // Reads until the server closes the connection.
    public static async Task<(WebSocketCloseStatus? Status, string? Reason)> ReadToEndAsync(this WebSocket socket)
    {
        while ((await socket.ReadAsync()).Type != WebSocketMessageType.Close)
        {
        }

        return (socket.CloseStatus, socket.CloseStatusDescription);
    }
}
