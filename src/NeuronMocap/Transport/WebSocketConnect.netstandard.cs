using System.Net.WebSockets;

namespace NeuronMocap.Transport;

internal static class WebSocketConnect
{
    // This target framework gives no access to the TCP connection.
    public static Task ConnectAsync(ClientWebSocket socket, Uri address, CancellationToken cancellationToken) => socket.ConnectAsync(address, cancellationToken);
}
