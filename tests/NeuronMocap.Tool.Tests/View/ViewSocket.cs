using System.Net.WebSockets;
using System.Text;
using System.Text.Json;

namespace NeuronMocap.Tool.Tests.View;

/// <summary>A WebSocket as a page opens it.</summary>
internal sealed class ViewSocket : IDisposable
{
    private readonly ClientWebSocket _socket = new();

    public WebSocketState State => _socket.State;

    public WebSocketCloseStatus? CloseStatus => _socket.CloseStatus;

    public static async Task<ViewSocket> ConnectAsync(Uri address, string? subprotocol, Action<ClientWebSocketOptions>? configure)
    {
        var socket = new ViewSocket();
        if (subprotocol is not null)
            socket._socket.Options.AddSubProtocol(subprotocol);

        socket._socket.Options.CollectHttpResponseDetails = true;
        configure?.Invoke(socket._socket.Options);
        await socket._socket.ConnectAsync(address, TestContext.Current.CancellationToken).Soon();
        return socket;
    }

    public Task SendAsync(string text) =>
        _socket.SendAsync(Encoding.UTF8.GetBytes(text), WebSocketMessageType.Text, endOfMessage: true, TestContext.Current.CancellationToken).Soon();

    /// <summary>Receives a message; null when the server closes.</summary>
    public async Task<byte[]?> ReceiveAsync()
    {
        using var message = new MemoryStream();
        byte[] buffer = new byte[16 * 1024];
        while (true)
        {
            WebSocketReceiveResult result = await _socket.ReceiveAsync(buffer, TestContext.Current.CancellationToken).Soon();
            if (result.MessageType == WebSocketMessageType.Close)
                return null;

            message.Write(buffer, 0, result.Count);
            if (result.EndOfMessage)
                return message.ToArray();
        }
    }

    /// <summary>Receives JSON messages until one is of a type and meets a condition.</summary>
    public async Task<JsonElement> FindAsync(string type, Predicate<JsonElement>? isWanted = null)
    {
        while (true)
        {
            byte[]? bytes = await ReceiveAsync();
            Assert.NotNull(bytes);
            JsonElement message = JsonDocument.Parse(bytes).RootElement;
            if (message.GetProperty("type").ValueEquals(type) && isWanted?.Invoke(message) != false)
                return message;
        }
    }

    public Task CloseAsync() => _socket.CloseAsync(WebSocketCloseStatus.NormalClosure, statusDescription: null, TestContext.Current.CancellationToken).Soon();

    public void Dispose() => _socket.Dispose();
}
