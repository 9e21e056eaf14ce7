using System.Net.Sockets;
using Microsoft.AspNetCore.Connections.Features;
using Microsoft.AspNetCore.Http.Features;
using NeuronMocap.Transport;

namespace NeuronMocap.AspNetCore.Connections;

// The socket below a connection of Kestrel.
internal static class ConnectionSocket
{
    // The default of the system is megabytes: many seconds of old frames for a client that does not read. A message has 4 to 12 KB.
    private const int SendBufferSize = 48 * 1024;

    /// <summary>Limits what the system holds for a client that does not read, and lets it notice a client that is gone.</summary>
    /// <param name="features">The features of the connection. Some connections have no socket.</param>
    public static void Prepare(IFeatureCollection features)
    {
        if (features.Get<IConnectionSocketFeature>()?.Socket is not { } socket)
            return;

        try
        {
            socket.SendBufferSize = SendBufferSize;
            TcpKeepAlive.Enable(socket);
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException)
        {
            // The client is gone already, or this kind of socket has no such option.
        }
    }
}
