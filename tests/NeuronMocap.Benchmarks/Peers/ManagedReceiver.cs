using System.Diagnostics;
using System.Net.Sockets;
using System.Runtime.InteropServices;
using NeuronMocap.Benchmarks.Harness;

namespace NeuronMocap.Benchmarks.Peers;

// Receivers in a process of their own that print what those of tests/native/bench print: the library's callback, and a client as tutorials write it, which
// reads each value with a BinaryReader from the stream.
internal static class ManagedReceiver
{
    public static async Task RunAsync(string way, string mode, int port, int frames)
    {
        List<long> delays = new(mode == "latency" ? frames : 0);
        long received = 0;
        long begun = 0;
        TimeSpan cpu = default;
        if (way == "library")
            await ReadAsync(port, Take);
        else
            Read(port, Take);

        if (mode == "latency")
        {
            foreach (long delay in delays)
                Console.WriteLine(delay);
        }
        else
        {
            long time = Nanoseconds(Stopwatch.GetTimestamp() - begun);
            Console.WriteLine($"frames {received}\nnanoseconds {time}\ncpu {(RuntimeFigures.CpuTime - cpu).Ticks * 100}");
        }

        void Take(ReadOnlySpan<float> values)
        {
            long now = Stopwatch.GetTimestamp();
            if (received++ == 0)
            {
                begun = now;
                cpu = RuntimeFigures.CpuTime;
            }

            if (mode == "latency")
                delays.Add(Nanoseconds(now - TestFrame.GetTime(MemoryMarshal.AsBytes(values))));
        }
    }

    private delegate void Taker(ReadOnlySpan<float> values);

    private static async Task ReadAsync(int port, Taker take)
    {
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = port, Reconnect = { Enabled = false } });
        reader.MotionReceived += frame => take(frame.Values);
        reader.Start();
        await reader.Completion;
    }

    private static void Read(int port, Taker take)
    {
        using var client = new TcpClient("127.0.0.1", port);
        using var reader = new BinaryReader(client.GetStream());
        float[] values = new float[(TestFrame.Size - TestFrame.HeaderSize) / sizeof(float)];
        while (reader.ReadBytes(TestFrame.HeaderSize).Length == TestFrame.HeaderSize)
        {
            for (int i = 0; i < values.Length; i++)
                values[i] = reader.ReadSingle();

            take(values);
        }
    }

    private static long Nanoseconds(long ticks) => (long)(ticks * 1e9 / Stopwatch.Frequency);
}
