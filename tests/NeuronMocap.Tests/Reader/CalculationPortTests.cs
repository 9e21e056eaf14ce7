using System.Net;
using System.Net.Sockets;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// Motion and calculation data on separate ports, as servers usually send them.
public sealed class CalculationPortTests : IDisposable
{
    private const int Frames = 200;

    private readonly TestServer _motion = new();
    private readonly TestServer _calculation = new();
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("neuron-calculation-port");

    private string Recording => Path.Combine(_folder.FullName, "take.nmrec");

    public void Dispose()
    {
        _motion.Dispose();
        _calculation.Dispose();
        _folder.Delete(recursive: true);
    }

    [Theory]
    [InlineData(TransportKind.Tcp)]
    [InlineData(TransportKind.Udp)]
    public async Task Frames_of_both_ports_reach_all_consumers_as_one_sender(TransportKind transport)
    {
        List<int> motionSources = [], calculationSources = [];
        FrameQueue? queue = null;
        LatestFrames? latest = null;
        (NeuronReader reader, Broadcaster broadcaster) = await ServeAsync(transport, reader =>
        {
            queue = reader.OpenQueue(4 * Frames);
            latest = reader.OpenLatest();
            reader.MotionReceived += frame => motionSources.Add(frame.Sender);
            reader.CalculationReceived += frame => calculationSources.Add(frame.Sender);
        });
        await using NeuronReader reading = reader;
        await using Broadcaster serving = broadcaster;
        await reader.UntilAsync(static statistics => statistics is { MotionFrames: Frames, CalculationFrames: Frames });

        int motion = 0, calculation = 0;
        await Limits.UntilAsync(() => queue!.Pump<AvatarFrame>(frame => _ = frame is MotionFrame ? motion++ : calculation++) >= 0 && motion == Frames && calculation == Frames);
        Assert.True(latest!.TryTakeMotion(0, out _) && latest.TryTakeCalculation(0, out _));
        Assert.Equal([0], motionSources.Concat(calculationSources).Distinct());
        Assert.Equal((Frames, Frames), (motionSources.Count, calculationSources.Count));
        Assert.Equal(0, reader.GetStatistics().Lost);
        Assert.Equal(2, reader.GetAvatarStatistics().Count);
    }

    [Fact]
    public async Task A_refused_calculation_port_is_reported_while_motion_continues()
    {
        int port = _calculation.Port;
        _calculation.Dispose();
        NeuronReaderOptions options = _motion.Options(reconnect: true);
        options.CalculationPort = port;
        await using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection connection = await _motion.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 10));
        await reader.WaitForFramesAsync(10);

        ConnectionStatus told = await log.WaitAsync(status => status is { State: ConnectionState.Receiving, Reason: ConnectionReason.CalculationUnavailable });
        Assert.Contains($"Calculation port {port}: connection refused.", told.Message, StringComparison.Ordinal);
        await Limits.UntilAsync(() => reader.CalculationStatus is { State: ConnectionState.Waiting, Reason: ConnectionReason.Refused, Attempt: > 3 });
        Assert.True(log.All.Count < 12, string.Join('\n', log.All));

        // The server starts later.
        using var server = new TestServer(IPAddress.Loopback, port);
        using TestConnection late = await server.AcceptAsync();
        await late.SendAsync(TestPackets.Calculation(1));
        ConnectionStatus receiving = await log.WaitAsync(status => status is { State: ConnectionState.Receiving, Reason: ConnectionReason.None } && status.Message.Contains($"{port}: receiving.", StringComparison.Ordinal));
        await reader.UntilAsync(static statistics => statistics.CalculationFrames == 1);
        Assert.Contains("Receiving from", receiving.Message, StringComparison.Ordinal);
    }

    // Each change of the calculation port reports the first connection's state again.
    [Fact]
    public async Task An_unstable_calculation_port_repeats_no_commands()
    {
        using CommandScript commands = FormatDiscoveryTests.Commands(new SkeletonFormat(RotationOrder.ZXY, SkeletonVariant.Spine3));
        NeuronReaderOptions options = _motion.Options(reconnect: true);
        (options.CommandPort, options.CalculationPort) = (commands.Port, _calculation.Port);
        int connected = 0;
        await using var reader = new NeuronReader(options);
        reader.StatusChanged += status => connected += status.State == ConnectionState.Connected ? 1 : 0;
        reader.Start();
        using TestConnection motion = await _motion.AcceptAsync();
        await Limits.UntilAsync(() => reader.Format.Discovered.Variant is not null);
        for (int told = 0; told < 4; told = Volatile.Read(ref connected))
        {
            using TestConnection calculation = await _calculation.AcceptAsync();
            await Limits.UntilAsync(() => reader.CalculationStatus is { State: ConnectionState.Connected });
        }

        // Accepts one more connection. The requests before it have been answered by then.
        using TestConnection last = await _calculation.AcceptAsync();
        await Limits.UntilAsync(() => reader.CalculationStatus is { State: ConnectionState.Connected });
        Assert.Equal(2, commands.Requests);
    }

    [Fact]
    public async Task Each_connection_reconnects_independently()
    {
        await using NeuronReader reader = CreateReader(TransportKind.Tcp, reconnect: true);
        reader.Start();
        using TestConnection motion = await _motion.AcceptAsync();
        for (int i = 0; i < 5; i++)
        {
            using TestConnection calculation = await _calculation.AcceptAsync();
            await calculation.SendAsync(TestPackets.Calculation(i));
            await motion.SendAsync(TestPackets.Motion(i));
            await reader.UntilAsync(statistics => statistics.CalculationFrames == i + 1 && statistics.MotionFrames == i + 1);

            // The reader connects again as soon as this connection is closed.
            ReaderStatistics statistics = reader.GetStatistics();
            Assert.Equal((0L, i, 0L), (statistics.Reconnects, statistics.CalculationReconnects, statistics.Lost));
        }
    }

    [Fact]
    public async Task A_silent_calculation_port_is_reported_while_motion_arrives()
    {
        await using NeuronReader reader = CreateReader(TransportKind.Tcp, silence: TimeSpan.FromMilliseconds(100));
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection motion = await _motion.AcceptAsync();
        using TestConnection calculation = await _calculation.AcceptAsync();
        Task<ConnectionStatus> told = log.WaitAsync(status => status is { State: ConnectionState.Receiving, Reason: ConnectionReason.CalculationUnavailable });
        for (int i = 0; !told.IsCompleted; i++)
        {
            await motion.SendAsync(TestPackets.Motion(i));
            await Task.Delay(1, TestContext.Current.CancellationToken);
        }

        Assert.Contains($"Calculation port {_calculation.Port}: Connected to", (await told).Message, StringComparison.Ordinal);
        Assert.Equal(ConnectionState.Silent, reader.CalculationStatus!.Value.State);
    }

    [Fact]
    public async Task Motion_on_the_calculation_port_is_skipped_and_reported()
    {
        await using NeuronReader reader = CreateReader(TransportKind.Tcp, silence: TimeSpan.FromMilliseconds(100));
        reader.Start();
        using TestConnection motion = await _motion.AcceptAsync();
        using TestConnection calculation = await _calculation.AcceptAsync();
        await calculation.SendAsync(TestPackets.Motions(0, 10));
        await motion.SendAsync(TestPackets.Motions(0, 10));
        await reader.WaitForFramesAsync(10);
        await Limits.UntilAsync(() => reader.GetStatistics().BytesSkipped == 10 * 1480);
        await Limits.UntilAsync(() => reader.CalculationStatus is { State: ConnectionState.Silent, Reason: ConnectionReason.UnknownFormat });
        Assert.Contains("motion data", reader.CalculationStatus!.Value.Message, StringComparison.Ordinal);
        Assert.Equal(10, reader.GetStatistics().MotionFrames);
    }

    [Fact]
    public async Task Motion_as_text_on_the_calculation_port_is_skipped_and_reported()
    {
        await using NeuronReader reader = CreateReader(TransportKind.Tcp, silence: TimeSpan.FromMilliseconds(100));
        reader.Start();
        using TestConnection motion = await _motion.AcceptAsync();
        using TestConnection calculation = await _calculation.AcceptAsync();
        byte[] text = System.Text.Encoding.ASCII.GetBytes(string.Concat(Enumerable.Range(0, 10).Select(static frame => Protocol.TextReading.Line(frame, 354, " \n"))));
        await calculation.SendAsync(text);
        await Limits.UntilAsync(() => reader.GetStatistics().BytesSkipped == text.Length);
        await Limits.UntilAsync(() => reader.CalculationStatus is { State: ConnectionState.Silent, Reason: ConnectionReason.UnknownFormat });
        Assert.Contains("motion data", reader.CalculationStatus!.Value.Message, StringComparison.Ordinal);
        Assert.Equal(0, reader.GetStatistics().MotionFrames);
    }

    // Both threads deliver at full speed, but the consumers see one producer at a time.
    [Fact]
    public async Task Two_busy_connections_lose_nothing_and_keep_their_order()
    {
        const int Many = 5_000;
        await using NeuronReader reader = CreateReader(TransportKind.Tcp);
        using FrameQueue queue = reader.OpenQueue(2 * Many);
        int inside = 0, overlaps = 0;
        void Count()
        {
            overlaps += Interlocked.Increment(ref inside) > 1 ? 1 : 0;
            Interlocked.Decrement(ref inside);
        }

        reader.MotionReceived += _ => Count();
        reader.CalculationReceived += _ => Count();
        reader.Start();
        using TestConnection motion = await _motion.AcceptAsync();
        using TestConnection calculation = await _calculation.AcceptAsync();
        Task sending = Task.Run(async () =>
        {
            for (int i = 0; i < Many; i++)
                await motion.SendAsync(TestPackets.Motion(i));
        });
        for (int i = 0; i < Many; i++)
            await calculation.SendAsync(TestPackets.Calculation(i, count: 338));

        await sending.Soon();
        await reader.UntilAsync(static statistics => statistics is { MotionFrames: Many, CalculationFrames: Many });
        List<uint?> motionIndices = [], calculationIndices = [];
        await Limits.UntilAsync(() => queue.Count == 2 * Many);
        queue.Pump<AvatarFrame>(frame => (frame is MotionFrame ? motionIndices : calculationIndices).Add(frame.FrameIndex));
        Assert.Equal(Enumerable.Range(0, Many).Select(i => (uint?)i), motionIndices);
        Assert.Equal(Enumerable.Range(0, Many).Select(i => (uint?)i), calculationIndices);
        Assert.Equal((0, 0L, 0L), (overlaps, reader.GetStatistics().Lost, reader.GetStatistics().Dropped));
    }

    [Theory]
    [InlineData(TransportKind.Tcp)]
    [InlineData(TransportKind.Udp)]
    public async Task A_recording_keeps_both_ports_and_plays_both(TransportKind transport)
    {
        StreamRecorder? started = null;
        (NeuronReader reader, Broadcaster broadcaster) = await ServeAsync(transport, reader => started = reader.StartRecording(Recording));
        await using (reader)
        await using (broadcaster)
        {
            StreamRecorder recorder = started!;
            await reader.UntilAsync(static statistics => statistics is { MotionFrames: Frames, CalculationFrames: Frames });
            recorder.Dispose();
            Assert.Equal(0, recorder.GetStatistics().LostPieces);
        }

        using (var frames = RecordedFrameReader.Open(Recording))
        {
            while (frames.Read())
                Assert.Equal(0, frames.Frame.Sender);

            ReaderStatistics read = frames.GetStatistics();
            Assert.Equal((Frames, Frames, 0L, 0L, 0L), (read.MotionFrames, read.CalculationFrames, read.Lost, read.BytesSkipped, read.Reconnects));
        }

        using var player = RecordingPlayer.Open(Recording);
        player.Speed = RecordingPlayer.MaxSpeed;
        await using var playing = new NeuronReader(player);
        playing.Start();
        await playing.Completion.Soon();
        ReaderStatistics played = playing.GetStatistics();
        Assert.Equal((Frames, Frames, 0L, 0L, 0L), (played.MotionFrames, played.CalculationFrames, played.Lost, played.BytesSkipped, played.Reconnects));
    }

    [Fact]
    public async Task A_restarted_server_continues_on_both_UDP_ports()
    {
        await using NeuronReader reader = CreateReader(TransportKind.Udp);
        for (int i = 1; i <= 2; i++)
        {
            await using Broadcaster broadcaster = await SendToAsync(reader);
            await reader.UntilAsync(statistics => statistics.MotionFrames == i * Frames && statistics.CalculationFrames == i * Frames);
        }

        Assert.Equal([0], reader.GetAvatarStatistics().Select(avatar => avatar.Sender).Distinct());
        Assert.Equal(2, reader.GetAvatarStatistics().Count);
    }

    [Fact]
    public async Task Both_connections_end_with_the_reader()
    {
        NeuronReader reader = CreateReader(TransportKind.Tcp);
        reader.Start();
        using TestConnection motion = await _motion.AcceptAsync();
        using TestConnection calculation = await _calculation.AcceptAsync();
        await reader.DisposeAsync();
        await reader.Completion.Soon();
        await Limits.UntilAsync(() => calculation.Socket.Poll(0, SelectMode.SelectRead));
        Assert.Equal(ConnectionState.Stopped, reader.Status.State);
        Assert.Equal(ConnectionState.Stopped, reader.CalculationStatus!.Value.State);
    }

    [Fact]
    public async Task The_same_port_is_one_connection()
    {
        NeuronReaderOptions options = _motion.Options();
        options.CalculationPort = options.Port;
        await using var reader = new NeuronReader(options);
        Assert.Null(reader.CalculationStatus);
        reader.Start();
        using TestConnection connection = await _motion.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(TestPackets.Motion(1), TestPackets.Calculation(1)));
        await reader.UntilAsync(static statistics => statistics is { MotionFrames: 1, CalculationFrames: 1 });
    }

    private NeuronReader CreateReader(TransportKind transport, bool reconnect = false, TimeSpan? silence = null) => new(new NeuronReaderOptions
    {
        Transport = transport,
        LocalAddress = transport == TransportKind.Udp ? IPAddress.Loopback : null,
        Port = transport == TransportKind.Udp ? 0 : _motion.Port,
        CalculationPort = transport == TransportKind.Udp ? 0 : _calculation.Port,
        SilenceTimeout = silence ?? TimeSpan.FromSeconds(60),
        Reconnect = { Enabled = reconnect, InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(5) },
    });

    // Starts a real server and a reader for it. The reader is prepared before the first frame.
    private async Task<(NeuronReader Reader, Broadcaster Server)> ServeAsync(TransportKind transport, Action<NeuronReader> prepare)
    {
        if (transport == TransportKind.Udp)
        {
            NeuronReader listening = CreateReader(transport);
            prepare(listening);
            return (listening, await SendToAsync(listening));
        }

        BroadcasterOptions options = Options();
        (options.Port, options.CalculationPort, options.WaitForClient) = (0, 0, true);
        var server = new Broadcaster(options);
        server.Start();
        var reader = new NeuronReader(new NeuronReaderOptions
        {
            Port = server.LocalEndPoint!.Port,
            CalculationPort = server.CalculationEndPoint!.Port,
            SilenceTimeout = TimeSpan.FromSeconds(60),
        });
        prepare(reader);
        reader.Start();
        return (reader, server);
    }

    private static async Task<Broadcaster> SendToAsync(NeuronReader reader)
    {
        await reader.StartAsync().Soon();
        await Limits.UntilAsync(() => reader.CalculationStatus?.LocalEndPoint is not null);
        BroadcasterOptions options = Options();
        options.Port = null;
        options.UdpDestinations = [(IPEndPoint)reader.Status.LocalEndPoint!];
        options.CalculationPort = ((IPEndPoint)reader.CalculationStatus!.Value.LocalEndPoint!).Port;
        var server = new Broadcaster(options);
        server.Start();
        return server;
    }

    private static BroadcasterOptions Options() => new()
    {
        Sources = [new SyntheticSource()],
        FrameRate = 500,
        MaxFrames = Frames,
        Calculation = CalculationSynthesizer.Write,
        CloseTimeout = Limits.Unexpected,
    };
}
