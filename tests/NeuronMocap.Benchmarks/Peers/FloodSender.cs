using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Runtime.InteropServices;

namespace NeuronMocap.Benchmarks.Peers;

// Sends a number of frames to one client as fast as the client takes them, or one write in each millisecond. Prints the sum of all 32-bit words sent, and ends.
internal static class FloodSender
{
    public static void Run(int perWrite, int frames, bool isPaced)
    {
        byte[] block = new byte[perWrite * TestFrame.Size];
        ulong[] sums = new ulong[perWrite];
        for (int i = 0; i < perWrite; i++)
        {
            Span<byte> frame = block.AsSpan(i * TestFrame.Size, TestFrame.Size);
            TestFrame.Create(values: i + 1).CopyTo(frame);
            sums[i] = SumWords(frame);
        }

        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        Console.WriteLine(((IPEndPoint)listener.LocalEndpoint).Port);
        using Socket socket = listener.AcceptSocket();
        socket.NoDelay = true;
        uint index = 0;
        ulong sum = 0;
        long due = Stopwatch.GetTimestamp();
        for (int sent = 0; sent < frames; sent += perWrite)
        {
            if (isPaced)
                PacedSender.WaitUntil(due += Stopwatch.Frequency / 1000);

            int count = Math.Min(perWrite, frames - sent);
            for (int i = 0; i < count; i++)
            {
                sum += sums[i] + TestFrame.SumOfIndex(index);
                TestFrame.SetIndex(block.AsSpan(i * TestFrame.Size), index++);
            }

            SendAll(socket, block, count * TestFrame.Size);
        }

        socket.Shutdown(SocketShutdown.Send);
        Console.WriteLine(sum);
        socket.Receive(new byte[1]);
    }

    private static ulong SumWords(ReadOnlySpan<byte> frame)
    {
        ulong sum = 0;
        foreach (uint word in MemoryMarshal.Cast<byte, uint>(frame))
            sum += word;

        return sum;
    }

    public static void SendAll(Socket socket, byte[] bytes, int count)
    {
        for (int sent = 0; sent < count;)
            sent += socket.Send(bytes, sent, count - sent, SocketFlags.None);
    }
}
