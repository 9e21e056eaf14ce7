using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Benchmarks.Peers;

// Accepts connections and sends nothing, until its standard input ends.
internal static class SilentServer
{
    public static void Run(int connections)
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start(backlog: connections);
        Console.WriteLine(((IPEndPoint)listener.LocalEndpoint).Port);
        Socket[] sockets = [.. Enumerable.Range(0, connections).Select(_ => listener.AcceptSocket())];
        Console.In.ReadToEnd();
        foreach (Socket socket in sockets)
            socket.Dispose();
    }
}
