using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Diagnostics;

// Sends datagrams to a port of this computer, like a server that is set to UDP.
internal sealed class DatagramSender : IDisposable
{
    private static int _last = Random.Shared.Next(10_000);

    private readonly Socket _socket = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);

    public DatagramSender() => _socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));

    public EndPoint EndPoint => _socket.LocalEndPoint!;

    // Below the ports that systems assign automatically, so that no other test gets it in the meantime.
    public static int FreePort()
    {
        while (true)
        {
            int port = 20_000 + (Interlocked.Increment(ref _last) % 10_000);
            using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
            try
            {
                socket.Bind(new IPEndPoint(IPAddress.Any, port));
                return port;
            }
            catch (SocketException)
            {
                // The port is in use. Tries the next one.
            }
        }
    }

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
