using System.Net.WebSockets;
using System.Runtime.CompilerServices;

namespace NeuronMocap.Transport;

// The read of pipes. Its state is pooled, so waiting for a frame allocates nothing.
internal sealed partial class WebSocketStream
{
    [AsyncMethodBuilder(typeof(PoolingAsyncValueTaskMethodBuilder<>))]
    public override async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default)
    {
        // A wait for bytes without a buffer. The next read, with one, waits in its place.
        if (buffer.IsEmpty)
            return 0;

        while (true)
        {
            ValueWebSocketReceiveResult result = await socket.ReceiveAsync(buffer, cancellationToken).ConfigureAwait(false);
            if (result.MessageType == WebSocketMessageType.Close)
                return End();
            if (result.Count > 0)
                return result.Count;
        }
    }
}
