using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Benchmarks.Peers;

// Sockets in one process that send datagrams to a port in turn, each its own avatar, as fast as they can. They begin when standard input ends.
internal static class DatagramSenders
{
    public static void Run(int port, int senders, int frames)
    {
        Socket[] sockets = [.. Enumerable.Range(0, senders).Select(_ => new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp))];
        byte[][] packets = [.. Enumerable.Range(0, senders).Select(static avatar => TestFrame.Create(avatar))];
        foreach (Socket socket in sockets)
            socket.Connect(IPAddress.Loopback, port);

        Console.WriteLine(port);
        Console.In.ReadToEnd();
        for (int sent = 0; sent < frames; sent++)
        {
            int sender = sent % senders;
            TestFrame.SetIndex(packets[sender], (uint)(sent / senders));
            sockets[sender].Send(packets[sender]);
        }
    }
}
