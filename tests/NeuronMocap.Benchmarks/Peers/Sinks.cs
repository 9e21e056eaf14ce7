using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Benchmarks.Peers;

// Clients of a server, in their own process. Each reads until the server closes. Prints when all are connected. At the end, prints the frames of the
// client that got fewest, the frames that are missing between others at any client, the lowest last frame number, and the seconds between the first and
// last bytes.
internal static class Sinks
{
    public static void Run(int port, int connections, bool withIdler)
    {
        using Socket? idler = withIdler ? Connect(port) : null;
        Socket[] sockets = [.. Enumerable.Range(0, connections).Select(_ => Connect(port))];
        long[] received = new long[connections];
        FrameNumbers[] numbers = [.. Enumerable.Range(0, connections).Select(_ => new FrameNumbers())];
        long start = 0;
        Thread[] threads = [.. sockets.Select((socket, i) => new Thread(() => Read(socket, ref received[i], numbers[i], ref start)))];
        foreach (Thread thread in threads)
            thread.Start();

        Console.WriteLine(port);
        foreach (Thread thread in threads)
            thread.Join();

        double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{received.Min() / TestFrame.Size} {numbers.Sum(static one => one.Missing)} {numbers.Min(static one => one.Last)} {seconds}"));
    }

    private static Socket Connect(int port)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        socket.Connect(IPAddress.Loopback, port);
        return socket;
    }

    private static void Read(Socket socket, ref long received, FrameNumbers numbers, ref long start)
    {
        byte[] buffer = new byte[128 * 1024];
        while (socket.Receive(buffer) is > 0 and var count)
        {
            if (received == 0)
                Interlocked.CompareExchange(ref start, Stopwatch.GetTimestamp(), 0);

            received += count;
            numbers.Read(buffer.AsSpan(0, count));
        }

        socket.Dispose();
    }
}
