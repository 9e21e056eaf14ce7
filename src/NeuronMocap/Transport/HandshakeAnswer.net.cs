using System.Net.WebSockets;

namespace NeuronMocap.Transport;

// The HTTP status with which a server answered a WebSocket handshake; null if there was no answer.
internal static class HandshakeAnswer
{
    public static int? Of(ClientWebSocket socket) => (int)socket.HttpStatusCode is > 0 and var status ? status : null;

    public static void Collect(ClientWebSocket socket) => socket.Options.CollectHttpResponseDetails = true;
}
