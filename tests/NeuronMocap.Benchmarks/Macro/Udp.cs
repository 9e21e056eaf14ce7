using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Transport;

namespace NeuronMocap.Benchmarks.Macro;

// Datagrams as fast as the senders can. UDP has no flow control, so the system drops what a receiver does not take in time. Both receivers have the same
// socket buffer.
internal static class Udp
{
    private const string Rate = "datagrams/s";
    private const string Cpu = "CPU ns/datagram";
    private const string Lost = "lost %";
    private static readonly TimeSpan FirstWait = TimeSpan.FromSeconds(30);
    private static readonly TimeSpan Quiet = TimeSpan.FromMilliseconds(300);

    private static readonly Aim[] Aims = [new(Rate, 0.9, IsRatio: true, IsLowerBound: true)];

    public static async Task<int> RunAsync(int[] counts, int frames, int runs, Report report)
    {
        report.Begin($"{frames} datagrams of {TestFrame.Size} bytes over loopback UDP, {runs} runs; the floor is a blocking receive with the same buffer of the system.");
        foreach (int senders in counts)
        {
            Way[] ways =
            [
                new("callback", () => CallbackAsync(senders, frames, ReceiveThread.Auto)),
                new("callback, pool threads", () => CallbackAsync(senders, frames, ReceiveThread.Pool)),
            ];
            report.Add(await Alternation.RunAsync($"{senders} senders", runs, new Way("raw", () => FloorAsync(senders, frames)), ways, Aims));
        }

        return report.End();
    }

    private static Task<Peer> StartSendersAsync(int port, int senders, int frames) =>
        Peer.StartAsync("floodudp", "--port", Peer.Text(port), "--connections", Peer.Text(senders), "--frames", Peer.Text(frames));

    private static NeuronReaderOptions CreateOptions(ReceiveThread thread) => new() { Transport = TransportKind.Udp, Port = 0, ReceiveThread = thread };

    private static async Task<Measurements> FloorAsync(int senders, int frames)
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.ReceiveBufferSize = UdpSocket.WantedBuffer;
        socket.ReceiveTimeout = (int)FirstWait.TotalMilliseconds;
        socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        using Peer peer = await StartSendersAsync(((IPEndPoint)socket.LocalEndPoint!).Port, senders, frames);
        byte[] buffer = new byte[64 * 1024];
        long received = 0;
        long first = 0;
        long last = 0;
        TimeSpan cpu = RuntimeFigures.CpuTime;
        peer.CloseInput();
        try
        {
            while (received < frames)
            {
                socket.Receive(buffer);
                last = Stopwatch.GetTimestamp();
                if (received++ == 0)
                {
                    first = last;
                    socket.ReceiveTimeout = (int)Quiet.TotalMilliseconds;
                }
            }
        }
        catch (SocketException exception) when (exception.SocketErrorCode == SocketError.TimedOut)
        {
            // The rest is lost.
        }

        return ToFigures(received, frames, Stopwatch.GetElapsedTime(first, last), RuntimeFigures.CpuTime - cpu);
    }

    private static async Task<Measurements> CallbackAsync(int senders, int frames, ReceiveThread thread)
    {
        await using var reader = new NeuronReader(CreateOptions(thread));
        long received = 0;
        long first = 0;
        long last = 0;
        reader.MotionReceived += frame =>
        {
            Volatile.Write(ref last, frame.Timestamp);
            if (received == 0)
                first = frame.Timestamp;

            Volatile.Write(ref received, received + 1);
        };
        await reader.StartAsync();
        using Peer peer = await StartSendersAsync(((IPEndPoint)reader.Status.LocalEndPoint!).Port, senders, frames);
        TimeSpan cpu = RuntimeFigures.CpuTime;
        peer.CloseInput();
        long seen = -1;
        while (Volatile.Read(ref received) is var now && now < frames && (now == 0 || now != seen))
        {
            seen = now;
            await Task.Delay(Quiet);
        }

        return ToFigures(received, frames, Stopwatch.GetElapsedTime(first, Volatile.Read(ref last)), RuntimeFigures.CpuTime - cpu);
    }

    private static Measurements ToFigures(long received, int frames, TimeSpan elapsed, TimeSpan cpu) => new()
    {
        [Rate] = received / elapsed.TotalSeconds,
        [Cpu] = cpu.TotalMilliseconds * 1e6 / received,
        [Lost] = (frames - received) * 100.0 / frames,
    };
}
