using System.Diagnostics;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Benchmarks.Peers;

// Sends frames to each of its clients one at a time, at a rate, and stamps each frame just before sending. The clients' frames are spread over the
// period, like those of independent servers.
internal static class PacedSender
{
    private const int MaxSlices = 16;

    public static void Run(int connections, double rate, double seconds)
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start(backlog: connections);
        Console.WriteLine(((IPEndPoint)listener.LocalEndpoint).Port);
        Socket[] sockets = new Socket[connections];
        for (int i = 0; i < connections; i++)
        {
            sockets[i] = listener.AcceptSocket();
            sockets[i].NoDelay = true;
        }

        Send(sockets, rate, seconds);
        foreach (Socket socket in sockets)
        {
            socket.Shutdown(SocketShutdown.Send);
            socket.Receive(new byte[1]);
            socket.Dispose();
        }
    }

    // Sends datagrams to a port of this machine where a receiver is already waiting.
    public static void RunUdp(int port, double rate, double seconds)
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.Connect(IPAddress.Loopback, port);
        Console.WriteLine(port);
        Send([socket], rate, seconds);
    }

    public static int FreePort()
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        return ((IPEndPoint)socket.LocalEndPoint!).Port;
    }

    private static void Send(Socket[] sockets, double rate, double seconds)
    {
        int slices = Math.Min(sockets.Length, MaxSlices);
        byte[] packet = TestFrame.Create();
        long frames = (long)(rate * seconds);
        long start = Stopwatch.GetTimestamp();
        for (uint frame = 0; frame < frames; frame++)
        {
            TestFrame.SetIndex(packet, frame);
            for (int slice = 0; slice < slices; slice++)
            {
                WaitUntil(start + (long)((frame + (slice / (double)slices)) / rate * Stopwatch.Frequency));
                for (int i = slice; i < sockets.Length; i += slices)
                {
                    TestFrame.SetTime(packet, Stopwatch.GetTimestamp());
                    FloodSender.SendAll(sockets[i], packet, packet.Length);
                }
            }
        }
    }

    public static void WaitUntil(long due)
    {
        double milliseconds = (due - Stopwatch.GetTimestamp()) * 1000.0 / Stopwatch.Frequency;
        if (milliseconds > 0)
            Thread.Sleep((int)Math.Ceiling(milliseconds));
    }
}
