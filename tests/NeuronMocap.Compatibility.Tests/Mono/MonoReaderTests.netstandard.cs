using System.Globalization;
using System.Net;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Mono;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Compatibility.Tests.Mono;

/// <summary>The reader, the player and the broadcaster on Mono, whose sockets, threads and tasks differ from those of .NET.</summary>
public sealed class MonoReaderTests(ITestOutputHelper output)
{
    private const int Frames = 200;
    private const int Connections = 10;
    private const int FramesAtATime = Frames / Connections;

    // Large, so that tests do not fail on a busy computer. A stop takes a few milliseconds, and the time is printed.
    private const double LongestStop = 1000;

    [Fact]
    public async Task Every_frame_arrives_over_tcp_and_udp_and_over_connections_that_end()
    {
        MonoProgram.Require();
        using var program = new MonoProgram();
        await program.CompileProgramAsync("Receiving");
        BroadcasterOptions options = Options(Frames);
        options.Port = 0;
        options.Fragment = 1000;
        using var server = new Broadcaster(options);
        server.Start();
        using var asking = new TestServer();
        using var closing = new TestServer();

        Task<string[]> run = program.RunAsync($"{server.LocalEndPoint!.Port}", $"{asking.Port}", $"{closing.Port}", $"{Frames}");
        using Broadcaster udp = await BroadcastToAsync(asking);
        await SendInTurnsAsync(closing);

        string[] lines = await run;
        string all = $"{Frames} {SumOf(SourceValues())} 0 0";
        Assert.Equal(["tcp " + all, "udp " + all, $"again {Frames} {SumOf(TestPacketValues())} 0 0"], lines[..^1]);

        // The last connection may be repeated.
        Assert.InRange(int.Parse(lines[^1], CultureInfo.InvariantCulture), Connections - 1, Connections);
    }

    [Fact]
    public async Task Every_object_stops_at_once_in_every_state_and_leaves_nothing()
    {
        MonoProgram.Require();
        using var program = new MonoProgram();
        await program.CompileProgramAsync("Stopping");
        BroadcasterOptions options = Options(frames: null);
        options.Port = 0;
        options.FrameRate = 200;
        using var sending = new Broadcaster(options);
        sending.Start();
        using var silent = new TestServer();
        using var blackHole = new BlackHole();
        string folder = Directory.CreateTempSubdirectory("neuron-mocap-mono-").FullName;
        try
        {
            string[] lines = await program.RunAsync(
                $"{silent.Port}", $"{sending.LocalEndPoint!.Port}", $"{blackHole.Port}", Path.Combine(folder, "take.nmrec"));
            foreach (string line in lines)
                output.WriteLine(line);

            Assert.Equal(21, lines.Length);
            Assert.All(lines[..^1], line => Assert.InRange(double.Parse(line.Split(": ")[1], CultureInfo.InvariantCulture), 0, LongestStop));
            Assert.Equal("left: 0 threads, 0 files", lines[^1]);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static BroadcasterOptions Options(int? frames) => new()
    {
        Sources = [new TestSource(0, frames)],
        Port = null,
        FrameRate = BroadcasterOptions.MaxFrameRate,
    };

    // The program reports its port over a connection.
    private static async Task<Broadcaster> BroadcastToAsync(TestServer asking)
    {
        using TestConnection connection = await asking.AcceptAsync();
        byte[] port = new byte[4];
        Assert.Equal(port.Length, await connection.Socket.ReceiveAsync(port, TestContext.Current.CancellationToken).AsTask().Soon());
        BroadcasterOptions options = Options(Frames);
        options.UdpDestinations = [new IPEndPoint(IPAddress.Loopback, BitConverter.ToInt32(port))];

        // Slow, because a receiver that a busy computer delays must find all datagrams in its buffer.
        options.FrameRate = 50;
        var broadcaster = new Broadcaster(options);
        broadcaster.Start();
        return broadcaster;
    }

    private static async Task SendInTurnsAsync(TestServer server)
    {
        for (int i = 0; i < Connections; i++)
        {
            using TestConnection connection = await server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motions(i * FramesAtATime, FramesAtATime));
            connection.Close();
        }
    }

    private static IEnumerable<float[]> SourceValues()
    {
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: false);
        for (int frame = 0; frame < Frames; frame++)
        {
            float[] values = new float[layout.ValueCount];
            new TestSource().WriteValues(frame, layout, RotationOrder.YXZ, values);
            yield return values;
        }
    }

    private static IEnumerable<float[]> TestPacketValues() => Enumerable.Range(0, Frames).Select(
        static frame => Enumerable.Range(0, 354).Select(index => TestPackets.Value(frame, avatar: 0, index)).ToArray());

    private static uint SumOf(IEnumerable<float[]> frames) =>
        frames.SelectMany(static values => values).Aggregate(0u, static (sum, value) => (sum * 31) + BitConverter.SingleToUInt32Bits(value));
}
