using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;
using static NeuronMocap.Server.Tests.Broadcasts;

namespace NeuronMocap.Server.Tests;

// Calculation packets only: on their own port beside the motion, or without motion.
public sealed class BroadcasterCalculationPortTests
{
    private const int Frames = 50;

    public static MatrixTheoryData<double, BroadcastFormat> Streams { get; } =
        new([BroadcasterOptions.MaxFrameRate, 2000], [BroadcastFormat.Binary, BroadcastFormat.Studio]);

    [Theory, MemberData(nameof(Streams))]
    public async Task Each_port_carries_its_own_packets_of_every_frame(double rate, BroadcastFormat format)
    {
        BroadcasterOptions options = Options(rate, format);
        await using Broadcaster broadcaster = Started(options);
        using TestClient motion = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        using TestClient calculation = await TestClient.ConnectAsync(broadcaster.CalculationEndPoint);
        Task<List<byte[]>> reading = calculation.ReadToEndAsync();
        List<byte[]> motionPackets = await motion.ReadToEndAsync();
        List<byte[]> calculationPackets = await reading.Soon();
        motion.Dispose();
        calculation.Dispose();
        await broadcaster.Completion.Soon();

        Expect.MotionFrames(motionPackets, options, Frames);
        Expect.CalculationFrames(calculationPackets, options, Frames);
        BroadcasterStatistics statistics = broadcaster.GetStatistics();
        Assert.Equal((2L * Frames, 2L * Frames, 0L), (statistics.FramesSent, statistics.CalculationFramesSent, statistics.PacketsDropped));
        Assert.Equal((2L, 0, 0), (statistics.Accepted, statistics.Clients, statistics.CalculationClients));
    }

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    [InlineData(2000)]
    public async Task Text_has_a_port_for_each_kind_of_line(double rate)
    {
        BroadcasterOptions options = Options(rate, BroadcastFormat.Text);
        await using Broadcaster broadcaster = Started(options);
        Task<string> calculation = TextClient.ReadToEndAsync(broadcaster.CalculationEndPoint);
        string[] motionLines = (await TextClient.ReadToEndAsync(broadcaster.LocalEndPoint).Soon()).Split('\n', StringSplitOptions.RemoveEmptyEntries);
        string[] calculationLines = (await calculation.Soon()).Split('\n', StringSplitOptions.RemoveEmptyEntries);
        await broadcaster.Completion.Soon();

        Assert.Equal(2 * Frames, motionLines.Length);
        Assert.All(motionLines, line => Assert.EndsWith("||\r", line, StringComparison.Ordinal));
        Assert.Equal(2 * Frames, calculationLines.Length);
        Assert.All(calculationLines, line => Assert.Equal(946, TextClient.ParseColumns(line).Length));
    }

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate, null)]
    [InlineData(2000, null)]
    [InlineData(2000, 1000)]
    public async Task Calculation_can_be_sent_alone(double rate, int? fragment)
    {
        BroadcasterOptions options = Options(rate, BroadcastFormat.Binary);
        options.CalculationPort = null;
        options.SendMotion = false;
        options.Fragment = fragment;
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        List<byte[]> packets = await client.ReadToEndAsync();

        Expect.CalculationFrames(packets, options, Frames);
        Assert.Null(broadcaster.CalculationEndPoint);
        Assert.Equal((0L, 2L * Frames), (broadcaster.GetStatistics().FramesSent, broadcaster.GetStatistics().CalculationFramesSent));
    }

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    [InlineData(2000)]
    public async Task Over_udp_calculation_has_its_own_socket_and_port_per_destination(double rate)
    {
        using Socket motion = Receiver();
        using Socket calculation = Receiver();
        BroadcasterOptions options = Options(rate, BroadcastFormat.Binary);
        options.Port = null;
        options.WaitForClient = false;
        options.UdpDestinations = [(IPEndPoint)motion.LocalEndPoint!];
        options.CalculationPort = ((IPEndPoint)calculation.LocalEndPoint!).Port;
        options.MaxFrames = 10;
        await using Broadcaster broadcaster = Started(options);
        (List<byte[]> motionPackets, HashSet<EndPoint> motionSenders) = await ReceiveAsync(motion, 20);
        (List<byte[]> calculationPackets, HashSet<EndPoint> calculationSenders) = await ReceiveAsync(calculation, 20);
        await broadcaster.Completion.Soon();

        Expect.MotionFrames(motionPackets, options, 10);
        Expect.CalculationFrames(calculationPackets, options, 10);
        Assert.NotEqual(Assert.Single(motionSenders), Assert.Single(calculationSenders));
        Assert.Null(broadcaster.CalculationEndPoint);
        Assert.Equal((20L, 20L), (broadcaster.GetStatistics().FramesSent, broadcaster.GetStatistics().CalculationFramesSent));
    }

    [Fact]
    public async Task The_same_udp_port_gets_both_from_two_sockets()
    {
        using Socket receiver = Receiver();
        BroadcasterOptions options = Options(BroadcasterOptions.MaxFrameRate, BroadcastFormat.Binary);
        options.Port = null;
        options.WaitForClient = false;
        options.UdpDestinations = [(IPEndPoint)receiver.LocalEndPoint!];
        options.CalculationPort = ((IPEndPoint)receiver.LocalEndPoint!).Port;
        options.MaxFrames = 10;
        await using Broadcaster broadcaster = Started(options);
        (List<byte[]> packets, HashSet<EndPoint> senders) = await ReceiveAsync(receiver, 40);

        Assert.Equal(2, senders.Count);
        Expect.MotionFrames([.. packets.Where(packet => packet.Length == 1480)], options, 10);
        Expect.CalculationFrames([.. packets.Where(packet => packet.Length != 1480)], options, 10);
    }

    [Fact]
    public async Task Each_port_has_its_own_clients_and_limit()
    {
        BroadcasterOptions options = Options(2000, BroadcastFormat.Binary);
        options.Sources = [new TestSource(0), new TestSource(1)];
        options.WaitForClient = false;
        options.MaxFrames = null;
        options.MaxClients = 1;
        await using Broadcaster broadcaster = Started(options);
        using TestClient calculation = await TestClient.ConnectAsync(broadcaster.CalculationEndPoint, allowsCutEnd: true);
        Assert.NotNull(await calculation.ReadAsync());
        using TestClient motion = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        Assert.NotNull(await motion.ReadAsync());
        using TestClient refused = await TestClient.ConnectAsync(broadcaster.CalculationEndPoint);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Refused == 1);

        Assert.Equal((2, 1), (broadcaster.GetStatistics().Clients, broadcaster.GetStatistics().CalculationClients));
        await Limits.UntilAsync(() => broadcaster.GetClients().All(client => client.FramesSent + client.CalculationFramesSent > 0));
        BroadcasterClient[] clients = [.. broadcaster.GetClients().OrderBy(client => client.IsCalculation)];
        Assert.Equal([false, true], clients.Select(client => client.IsCalculation));
        Assert.Equal([motion.Socket.LocalEndPoint, calculation.Socket.LocalEndPoint], clients.Select(client => client.RemoteEndPoint));
        Assert.Equal((0L, 0L), (clients[0].CalculationFramesSent, clients[1].FramesSent));
        Assert.True(clients[0].FramesSent > 0 && clients[1].CalculationFramesSent > 0);
    }

    // A take without pacing ends only when both ports have had a client. The second client may connect after the first was served.
    [Fact]
    public async Task An_unpaced_take_waits_for_a_client_on_each_port()
    {
        BroadcasterOptions options = Options(BroadcasterOptions.MaxFrameRate, BroadcastFormat.Binary);
        await using Broadcaster broadcaster = Started(options);
        using (TestClient motion = await TestClient.ConnectAsync(broadcaster.LocalEndPoint))
            Expect.MotionFrames(await motion.ReadToEndAsync(), options, Frames);

        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 0);
        using (TestClient calculation = await TestClient.ConnectAsync(broadcaster.CalculationEndPoint))
            Expect.CalculationFrames(await calculation.ReadToEndAsync(), options, Frames);

        await broadcaster.Completion.Soon();
    }

    [Fact]
    public async Task A_zero_out_applies_to_both_ports_from_the_same_frame()
    {
        BroadcasterOptions options = Options(BroadcasterOptions.MaxFrameRate, BroadcastFormat.Binary);
        var actor = new SyntheticSource();
        options.Sources = [actor];
        options.Calculation = CalculationSynthesizer.Write;
        options.FrameRate = 500;
        options.MaxFrames = 40;
        var time = new ManualTime();
        await using var broadcaster = new Broadcaster(options, time);
        broadcaster.Start();
        using TestClient motion = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        using TestClient calculation = await TestClient.ConnectAsync(broadcaster.CalculationEndPoint);
        for (int i = 0; i < 10; i++)
        {
            if (i > 0)
                await time.PassAsync();

            Assert.NotNull(await motion.ReadAsync());
        }

        Assert.True(broadcaster.ZeroOut(0));
        Task<List<byte[]>> reading = motion.ReadToEndAsync();
        for (int i = 10; i < 40; i++)
            await time.PassAsync();

        List<byte[]> turnedMotion = await reading;
        List<byte[]> turnedCalculation = await calculation.ReadToEndAsync();
        uint lastFrame = Expect.FrameIndex(turnedMotion[^1]);
        float[] values = new float[946];
        CalculationSynthesizer.Write(actor, lastFrame, values);
        Assert.NotEqual(BitConverter.ToSingle(turnedCalculation[^1], 64 + (6 * 4)), values[6]);
        Assert.Equal(40, turnedCalculation.Count);
    }

    [Fact]
    public void A_port_in_use_is_named_and_the_start_can_be_repeated()
    {
        using var other = new TcpListener(IPAddress.Loopback, FreePort.Next());
        other.Start();
        BroadcasterOptions options = Options(2000, BroadcastFormat.Binary);
        options.CalculationPort = ((IPEndPoint)other.LocalEndpoint).Port;
        using var broadcaster = new Broadcaster(options);
        BroadcasterException exception = Assert.Throws<BroadcasterException>(broadcaster.Start);
        Assert.Equal("CalculationPort", exception.Setting);
        Assert.Contains("CalculationPort", exception.Message, StringComparison.Ordinal);
        Assert.Null(broadcaster.LocalEndPoint);
        other.Stop();
        broadcaster.Start();
        Assert.Equal(options.CalculationPort, broadcaster.CalculationEndPoint!.Port);
    }

    [Fact]
    public void Contradictory_settings_are_refused_by_name()
    {
        AssertRefused("CalculationPort", options => options.CalculationPort = 65_536);
        AssertRefused("CalculationPort", options => options.Calculation = null);
        AssertRefused("CalculationPort", options => options.SendMotion = false);
        AssertRefused("CalculationPort", options => options.CalculationPort = options.Port = 7001);
        AssertRefused("CalculationPort", options => options.UdpDestinations = [new IPEndPoint(IPAddress.Loopback, 7001)]);
        AssertRefused("SendMotion", options => (options.SendMotion, options.CalculationPort, options.Calculation) = (false, null, null));
    }

    private static void AssertRefused(string setting, Action<BroadcasterOptions> change)
    {
        BroadcasterOptions options = Options(2000, BroadcastFormat.Binary);
        change(options);
        Assert.Equal(setting, Assert.Throws<ArgumentException>(() => new Broadcaster(options)).ParamName);
    }

    private static BroadcasterOptions Options(double rate, BroadcastFormat format)
    {
        BroadcasterOptions options = Expect.Options(avatars: 2, frames: Frames);
        options.FrameRate = rate;
        options.Format = format;
        options.CalculationPort = 0;
        options.WaitForClient = true;
        options.QueueCapacity = 1000;
        if (format == BroadcastFormat.Studio)
            options.StudioCalculation = static (_, frame, payload) => payload.Fill((byte)frame);
        else
            options.Calculation = format == BroadcastFormat.Text ? CalculationSynthesizer.Write : TestSource.WriteCalculation;

        if (format == BroadcastFormat.Text)
            options.Sources = [.. Enumerable.Range(0, 2).Select(avatar => new SyntheticSource(avatarIndex: avatar))];

        options.MaxFrames = Frames;
        return options;
    }

    private static async Task<(List<byte[]> Packets, HashSet<EndPoint> Senders)> ReceiveAsync(Socket socket, int count)
    {
        byte[] buffer = new byte[65_536];
        var packets = new List<byte[]>();
        var senders = new HashSet<EndPoint>();
        while (packets.Count < count)
        {
            SocketReceiveFromResult result = await socket.ReceiveFromAsync(
                buffer.AsMemory(), SocketFlags.None, new IPEndPoint(IPAddress.Any, 0), TestContext.Current.CancellationToken).Soon();
            packets.Add(buffer[..result.ReceivedBytes]);
            senders.Add(result.RemoteEndPoint);
        }

        return (packets, senders);
    }
}
