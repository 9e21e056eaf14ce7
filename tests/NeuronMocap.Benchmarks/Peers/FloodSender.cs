using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Benchmarks.Peers;

// Sends one client so many frames as fast as they are taken, and ends.
internal static class FloodSender
{
    public static void Run(int perWrite, int frames)
    {
        byte[] block = new byte[perWrite * TestFrame.Size];
        for (int i = 0; i < perWrite; i++)
            TestFrame.Create().CopyTo(block.AsSpan(i * TestFrame.Size));

        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        Console.WriteLine(((IPEndPoint)listener.LocalEndpoint).Port);
        using Socket socket = listener.AcceptSocket();
        socket.NoDelay = true;
        uint index = 0;
        for (int sent = 0; sent < frames; sent += perWrite)
        {
            int count = Math.Min(perWrite, frames - sent);
            for (int i = 0; i < count; i++)
                TestFrame.SetIndex(block.AsSpan(i * TestFrame.Size), index++);

            SendAll(socket, block.AsSpan(0, count * TestFrame.Size));
        }

        socket.Shutdown(SocketShutdown.Send);
        socket.Receive(new byte[1]);
    }

    public static void SendAll(Socket socket, ReadOnlySpan<byte> bytes)
    {
        while (bytes.Length > 0)
            bytes = bytes[socket.Send(bytes)..];
    }
}
