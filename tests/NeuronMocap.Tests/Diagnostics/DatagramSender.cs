using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Diagnostics;

// Sends datagrams to a port of this computer, like a server that is set to UDP.
internal sealed class DatagramSender : IDisposable
{
    private readonly Socket _socket = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);

    public DatagramSender() => _socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));

    public EndPoint EndPoint => _socket.LocalEndPoint!;

    // Sends groups of datagrams by number, one after the other, until the task ends.
    public async Task<T> SendUntilAsync<T>(Task<T> task, int port, Func<int, IEnumerable<byte[]>> datagrams)
    {
        var target = new IPEndPoint(IPAddress.Loopback, port);
        for (int i = 0; !task.IsCompleted; i++)
        {
            foreach (byte[] datagram in datagrams(i))
                await _socket.SendToAsync(datagram, SocketFlags.None, target);

            await Task.Delay(1, TestContext.Current.CancellationToken);
        }

        return await task.Soon();
    }

    public void Dispose() => _socket.Dispose();
}
