using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Benchmarks.Peers;

// The least that a relay does: one thread receives, and sends the same bytes to each client. A client that does not read stops it.
internal sealed class BareRelay : IDisposable
{
    private const int BufferSize = 256 * 1024;

    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);

    public BareRelay() => _listener.Start(backlog: 100);

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    // Waits for the clients, and then connects to the server.
    public async Task StartAsync(int serverPort, int clients)
    {
        var sockets = new List<Socket>();
        while (sockets.Count < clients)
        {
            Socket socket = await _listener.AcceptSocketAsync();
            socket.NoDelay = true;
            sockets.Add(socket);
        }

        var server = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        server.Connect(IPAddress.Loopback, serverPort);
        new Thread(() => Run(server, sockets)) { IsBackground = true }.Start();
    }

    public void Dispose() => _listener.Dispose();

    private static void Run(Socket server, List<Socket> clients)
    {
        byte[] buffer = new byte[BufferSize];
        while (server.Receive(buffer) is > 0 and var count)
        {
            foreach (Socket client in clients)
                FloodSender.SendAll(client, buffer, count);
        }

        server.Dispose();
        foreach (Socket client in clients)
        {
            client.Shutdown(SocketShutdown.Send);
            client.Dispose();
        }
    }
}
