using System.Net.Sockets;
using System.Net.WebSockets;

namespace NeuronMocap.Transport;

internal static class WebSocketConnect
{
    // The client of a WebSocket leaves its TCP connection without keep-alive, so it would notice a dead server after a quarter of an hour.
    public static async Task ConnectAsync(ClientWebSocket socket, Uri address, CancellationToken cancellationToken)
    {
        // Disposing the invoker does not close the connection, which then belongs to the socket.
        using var invoker = new HttpMessageInvoker(new SocketsHttpHandler { ConnectCallback = OpenAsync });
        await socket.ConnectAsync(address, invoker, cancellationToken).ConfigureAwait(false);
    }

    private static async ValueTask<Stream> OpenAsync(SocketsHttpConnectionContext context, CancellationToken cancellationToken)
    {
        var socket = new Socket(SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        try
        {
            TcpKeepAlive.Enable(socket);
            await socket.ConnectAsync(context.DnsEndPoint, cancellationToken).ConfigureAwait(false);
            return new NetworkStream(socket, ownsSocket: true);
        }
        catch
        {
            socket.Dispose();
            throw;
        }
    }
}
