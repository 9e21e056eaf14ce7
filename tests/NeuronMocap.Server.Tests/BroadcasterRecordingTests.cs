using System.Net;
using System.Net.Sockets;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Playback;
using NeuronMocap.Tests.Server;
using Worker = NeuronMocap.Server.Broadcasting.Worker;

namespace NeuronMocap.Server.Tests;

// A recording sent to programs that use the protocol.
public sealed class BroadcasterRecordingTests
{
    [Theory]
    [MemberData(nameof(WrittenStreams.Names), MemberType = typeof(WrittenStreams))]
    public async Task A_reader_gets_the_frames_and_the_noise_that_were_recorded(string name)
    {
        byte[] bytes = StreamFixture.Load(name).Bytes;
        using TemporaryFile file = Recordings.OfTcp([.. Splits.Random(bytes, new Random(3)).Select(static (piece, i) => (i / 10.0, piece.ToArray()))]);
        await AssertSameAsync(file, new BroadcasterOptions { RecordingPath = file.Path, Port = 0, WaitForClient = true });
        await AssertSameAsync(file, new BroadcasterOptions { RecordingPath = file.Path, Port = 0, FrameRate = BroadcasterOptions.MaxFrameRate, Fragment = 333 });
    }

    [Fact]
    public async Task A_raw_dump_goes_out_at_a_rate()
    {
        using var dump = new TemporaryFile(TestPackets.Motions(0, 20), ".bin");
        await AssertSameAsync(dump, new BroadcasterOptions { RecordingPath = dump.Path, Port = 0, WaitForClient = true, FrameRate = 1000 });
    }

    [Fact]
    public async Task Every_client_gets_every_byte_at_the_highest_rate()
    {
        using TemporaryFile file = Recordings.OfTcp([.. Enumerable.Range(0, 50).Select(static i => (i * 100.0, TestPackets.Motion(i)))]);
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { RecordingPath = file.Path, Port = 0, FrameRate = BroadcasterOptions.MaxFrameRate });
        broadcaster.Start();
        using TestClient first = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        using TestClient second = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        foreach (TestClient client in (TestClient[])[first, second])
            Assert.Equal(Enumerable.Range(0, 50).Select(static frame => (uint)frame), (await client.ReadToEndAsync().Soon()).Select(Expect.FrameIndex));

        Assert.Equal(100, broadcaster.GetStatistics().FramesSent);
    }

    [Fact]
    public async Task A_loop_repeats_and_late_clients_start_at_a_packet()
    {
        using TemporaryFile file = Recordings.OfTcp((0, TestPackets.Motion(0)), (5, TestPackets.Motion(1)), (10, TestPackets.Motion(2)));
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { RecordingPath = file.Path, Port = 0, LoopRecording = true, RecordingSpeed = 5, QueueCapacity = 20_000 });
        broadcaster.Start();
        for (int i = 0; i < 3; i++)
        {
            using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
            uint before = Expect.FrameIndex((await client.ReadAsync().Soon())!);
            for (int frame = 0; frame < 7; frame++)
            {
                uint next = Expect.FrameIndex((await client.ReadAsync().Soon())!);
                Assert.Equal((before + 1) % 3, next);
                before = next;
            }
        }
    }

    [Fact]
    public async Task Over_udp_a_packet_is_a_datagram()
    {
        using TemporaryFile file = Recordings.OfTcp((0, [.. TestPackets.Motion(0), .. TestPackets.Calculation(1)]), (1, TestPackets.Line(2)));
        using var receiver = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        receiver.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        foreach (double? rate in (double?[])[null, BroadcasterOptions.MaxFrameRate])
        {
            await using var broadcaster = new Broadcaster(new BroadcasterOptions
            {
                RecordingPath = file.Path,
                Port = null,
                UdpDestinations = [(IPEndPoint)receiver.LocalEndPoint!],
                FrameRate = rate,
            });
            broadcaster.Start();
            byte[] buffer = new byte[65_536];
            foreach (byte[] expected in (byte[][])[TestPackets.Motion(0), TestPackets.Calculation(1), TestPackets.Line(2)])
            {
                int count = await receiver.ReceiveAsync(buffer.AsMemory(), SocketFlags.None, TestContext.Current.CancellationToken).Soon();
                Assert.Equal(expected, buffer[..count]);
            }

            await broadcaster.Completion.Soon();
        }
    }

    [Fact]
    public void Meaningless_settings_are_refused_by_name()
    {
        using TemporaryFile file = Recordings.OfTcp((0, TestPackets.Motion(0)));
        AssertRefused(nameof(BroadcasterOptions.Sources), options => options.Sources = [new TestSource(0, 1)]);
        AssertRefused(nameof(BroadcasterOptions.AvatarNames), options => options.AvatarNames = ["a"]);
        AssertRefused(nameof(BroadcasterOptions.MaxFrames), options => options.MaxFrames = 1);
        AssertRefused(nameof(BroadcasterOptions.IncludeDisplacement), options => options.IncludeDisplacement = true);
        AssertRefused(nameof(BroadcasterOptions.IncludeReference), options => options.IncludeReference = true);
        AssertRefused(nameof(BroadcasterOptions.RotationOrder), options => options.RotationOrder = RotationOrder.XYZ);
        AssertRefused(nameof(BroadcasterOptions.Format), options => options.Format = BroadcastFormat.Text);
        AssertRefused(nameof(BroadcasterOptions.DataVersion), options => options.DataVersion = DataVersion.Old);
        AssertRefused(nameof(BroadcasterOptions.Calculation), options => options.Calculation = static (_, _, _) => { });
        AssertRefused(nameof(BroadcasterOptions.FrameRate), options => options.FrameRate = 60);
        AssertRefused(nameof(BroadcasterOptions.RecordingSpeed), options => options.RecordingSpeed = 0);
        AssertRefused(nameof(BroadcasterOptions.RecordingSpeed), options => (options.RecordingSpeed, options.FrameRate) = (2, BroadcasterOptions.MaxFrameRate));
        AssertRefused(nameof(BroadcasterOptions.LoopRecording), options => (options.Sources, options.RecordingPath, options.LoopRecording) = ([new TestSource(0, 1)], null, true));
        using var broadcaster = new Broadcaster(new BroadcasterOptions { RecordingPath = file.Path, Port = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => broadcaster.GetCombinationMode(0));
        Assert.False(broadcaster.ZeroOut(0));
        Assert.Throws<ArgumentException>(() => new CommandServer(broadcaster));

        void AssertRefused(string setting, Action<BroadcasterOptions> set)
        {
            var options = new BroadcasterOptions { RecordingPath = file.Path, Port = 0 };
            set(options);
            Assert.Contains($"BroadcasterOptions.{setting} ", Assert.Throws<ArgumentException>(() => new Broadcaster(options)).Message, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void An_unplayable_file_is_refused_at_once()
    {
        using var file = new TemporaryFile("nothing"u8.ToArray());
        Assert.Throws<PlaybackException>(() => new Broadcaster(new BroadcasterOptions { RecordingPath = file.Path }));
        Assert.Throws<FileNotFoundException>(() => new Broadcaster(new BroadcasterOptions { RecordingPath = file.Path + "x" }));
    }

    [Theory]
    [InlineData(null)]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    public async Task Calculation_of_a_recording_can_have_its_own_port(double? rate)
    {
        using TemporaryFile file = Recordings.OfTcp(
            [.. Enumerable.Range(0, 50).Select(static i => (i * 2.0, (byte[])[.. TestPackets.Motion(i), .. TestPackets.Calculation(i)]))]);
        await using var broadcaster = new Broadcaster(
            new BroadcasterOptions { RecordingPath = file.Path, Port = 0, CalculationPort = 0, WaitForClient = true, FrameRate = rate });
        broadcaster.Start();
        using TestClient motion = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        using TestClient calculation = await TestClient.ConnectAsync(broadcaster.CalculationEndPoint);
        Task<List<byte[]>> reading = calculation.ReadToEndAsync();

        Assert.Equal(Enumerable.Range(0, 50).SelectMany(static i => TestPackets.Motion(i)), (await motion.ReadToEndAsync().Soon()).SelectMany(static packet => packet));
        Assert.Equal(Enumerable.Range(0, 50).SelectMany(static i => TestPackets.Calculation(i)), (await reading.Soon()).SelectMany(static packet => packet));
        Assert.Equal((50L, 50L), (broadcaster.GetStatistics().FramesSent, broadcaster.GetStatistics().CalculationFramesSent));
    }

    // A recording has a handle for each receiver that reads it at its own speed. No handle may outlive the broadcast, whatever fails.
    [Fact]
    public async Task A_failed_receiver_closes_its_handle_of_the_recording()
    {
        if (!OperatingSystem.IsLinux())
            Assert.Skip("Only Linux tells which files a process has open.");

        using TemporaryFile file = Recordings.OfTcp([.. Enumerable.Range(0, 50).Select(static i => (i * 100.0, TestPackets.Motion(i)))]);
        var options = new BroadcasterOptions { RecordingPath = file.Path, Port = 0, FrameRate = BroadcasterOptions.MaxFrameRate };

        // There was no thread for the client.
        int refused = 0;
        await using (var broadcaster = new Broadcaster(options) { StartWorker = Start })
        {
            broadcaster.Start();
            using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
            Assert.Null(await client.ReadAsync());
            Assert.Equal(1, refused);
        }

        Assert.Equal(0, CountHandles(file.Path));

        // The port is taken.
        using var other = new TcpListener(IPAddress.Loopback, 0);
        other.Start();
        options.UdpDestinations = [new IPEndPoint(IPAddress.Loopback, 9)];
        options.Port = ((IPEndPoint)other.LocalEndpoint).Port;
        await using (var broadcaster = new Broadcaster(options))
            Assert.Throws<BroadcasterException>(broadcaster.Start);

        Assert.Equal(0, CountHandles(file.Path));

        // The destination waits for a client that never connects.
        options.Port = 0;
        options.WaitForClient = true;
        await using (var broadcaster = new Broadcaster(options))
            broadcaster.Start();

        Assert.Equal(0, CountHandles(file.Path));

        void Start(Worker worker)
        {
            refused++;
            throw new InvalidOperationException("There is no such thread.");
        }
    }

    private static int CountHandles(string path) => Directory.GetFiles("/proc/self/fd").Count(handle => TargetOf(handle) == path);

    // Other tests open and close files meanwhile.
    private static string? TargetOf(string handle)
    {
        try
        {
            return File.ResolveLinkTarget(handle, returnFinalTarget: false)?.FullName;
        }
        catch (IOException)
        {
            return null;
        }
    }

    private static async Task AssertSameAsync(TemporaryFile file, BroadcasterOptions options)
    {
        using RecordedFrameReader original = RecordedFrameReader.Open(file.Path);
        string[] expected = [.. RecordedFrames.ReadAll(original).Select(static read => Recordings.Describe(read.Frame))];
        await using var broadcaster = new Broadcaster(options);
        broadcaster.Start();
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = broadcaster.LocalEndPoint!.Port, Reconnect = { Enabled = false } });
        using var frames = new FrameLog(reader);
        reader.Start();
        await reader.Completion.Soon();
        await broadcaster.Completion.Soon();

        Assert.Equal(expected, frames.Lines);
        Assert.Equal(original.GetStatistics().BytesSkipped, reader.GetStatistics().BytesSkipped);
        Assert.Equal(original.GetStatistics().BytesReceived, reader.GetStatistics().BytesReceived);
        Assert.Equal(ConnectionReason.ClosedByPeer, reader.Status.Reason);
    }
}
