using System.Net.WebSockets;

namespace NeuronMocap.Transport;

// The bytes of all messages of a WebSocket, one after the other. Disposing it ends a pending read.
internal sealed partial class WebSocketStream(WebSocket socket, string name) : ReadOnlyStream
{
    // The thread belongs to the reader, and a WebSocket has no blocking read.
    public override int Read(byte[] buffer, int offset, int count) => ReadAsync(buffer, offset, count, CancellationToken.None).GetAwaiter().GetResult();

    public override async Task<int> ReadAsync(byte[] buffer, int offset, int count, CancellationToken cancellationToken)
    {
        while (true)
        {
            WebSocketReceiveResult result = await socket.ReceiveAsync(new ArraySegment<byte>(buffer, offset, count), cancellationToken).ConfigureAwait(false);
            if (result.MessageType == WebSocketMessageType.Close)
                return End();
            if (result.Count > 0)
                return result.Count;
        }
    }

    protected override void Dispose(bool disposing)
    {
        if (disposing)
            socket.Dispose();

        base.Dispose(disposing);
    }

    // The server says why it ends, unless its stream is simply over.
    private int End() => socket.CloseStatus is null or WebSocketCloseStatus.NormalClosure or WebSocketCloseStatus.EndpointUnavailable
        ? 0
        : throw new NeuronConnectionException(ConnectionReason.ClosedByPeer, $"{name} closed the connection: {socket.CloseStatusDescription}");
}
