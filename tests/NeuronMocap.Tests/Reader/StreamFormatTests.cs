using System.Collections.Concurrent;
using System.Net;
using System.Net.Sockets;
using System.Text;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// What the reader detects about a stream, and how it reports it.
public sealed class StreamFormatTests
{
    public static TheoryData<string, StreamFormat, string> Streams => new()
    {
        { "new", StreamFormat.Binary, ": binary format; rotation order YXZ assumed, the stream does not say." },
        { "old", StreamFormat.OldHeader, ": binary format with the old header; rotation order YXZ assumed, the stream does not say." },
        { "text", StreamFormat.Text, ": text format; rotation order YXZ assumed, the stream does not say." },
        { "studio", StreamFormat.Studio, ": binary format of Axis Studio; rotation order ZXY, as the stream says." },
        { "calculation", StreamFormat.Binary, ": binary format, calculation data." },
        { "text calculation", StreamFormat.Text, ": text format, calculation data." },
        { "studio calculation", StreamFormat.Studio, ": binary format of Axis Studio, calculation data." },
        { "both", StreamFormat.Binary, ": binary format; rotation order YXZ assumed, the stream does not say." },
    };

    [Theory]
    [MemberData(nameof(Streams))]
    public async Task The_status_describes_the_stream(string name, StreamFormat format, string text)
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(Stream(name, 1));

        ConnectionStatus status = await log.WaitAsync(status => status.Message.EndsWith(text, StringComparison.Ordinal));
        Assert.Equal((ConnectionState.Receiving, ConnectionReason.None, format), (status.State, status.Reason, status.Format));
        Assert.Equal($"Receiving from 127.0.0.1:{server.Port}{text}", status.Message);
        Assert.All(log.All.Where(status => !status.IsConnected || status.State == ConnectionState.Connected), status => Assert.Equal(StreamFormat.Unknown, status.Format));
    }

    [Fact]
    public async Task A_change_within_a_connection_is_reported()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        var log = new StatusLog(reader);
        ConcurrentQueue<ReaderEvent> lines = [];
        reader.EventReported += lines.Enqueue;
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        foreach ((string name, StreamFormat format, _) in ((string, StreamFormat, string)[])
            [("new", StreamFormat.Binary, ""), ("text", StreamFormat.Text, ""), ("studio", StreamFormat.Studio, ""), ("old", StreamFormat.OldHeader, "")])
        {
            Task<ConnectionStatus> told = log.WaitAsync(status => status.State == ConnectionState.Receiving && status.Format == format);
            await connection.SendAsync(Stream(name, 1));
            await told;
        }

        Assert.Equal(
            [StreamFormat.Binary, StreamFormat.Text, StreamFormat.Studio, StreamFormat.OldHeader],
            log.All.Where(status => status.State == ConnectionState.Receiving).Select(status => status.Format));
        Assert.Equal(4, lines.Count(line => line is { Id: ReaderEventId.Receiving, Level: ReaderEventLevel.Information }));
    }

    [Fact]
    public async Task Constant_changes_are_reported_at_intervals()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        byte[] both = [.. Stream("new", 1), .. Stream("text", 2)];
        for (int i = 0; i < 200; i++)
            await connection.SendAsync(both);

        connection.Close();
        await reader.Completion.Soon();
        Assert.Equal(400, reader.GetStatistics().MotionFrames);
        Assert.InRange(log.All.Count(status => status.State == ConnectionState.Receiving), 1, 30);
    }

    [Theory]
    [InlineData(RotationOrder.ZXY, false)]
    [InlineData(RotationOrder.YXZ, true)]
    public async Task A_stream_that_contradicts_the_options_is_reported_once_for_each_connection(RotationOrder option, bool contradicts)
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options(reconnect: true);
        options.RotationOrder = option;
        await using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        ConcurrentQueue<ReaderEvent> lines = [];
        RotationOrder used = default;
        reader.EventReported += lines.Enqueue;
        reader.MotionReceived += frame => used = frame.Format.RotationOrder;
        reader.Start();
        for (int i = 0; i < 2; i++)
        {
            using TestConnection connection = await server.AcceptAsync();
            long before = reader.GetStatistics().MotionFrames;
            for (int frame = 0; frame < 50; frame++)
                await connection.SendAsync(Stream("studio", frame));

            await reader.WaitForFramesAsync(before + 50);
            connection.Close();
        }

        await log.WaitAsync(status => status.State == ConnectionState.Waiting);
        ConnectionStatus[] receiving = [.. log.All.Where(status => status.State == ConnectionState.Receiving)];
        Assert.Equal(2, receiving.Length);
        Assert.Equal(option, used);
        Assert.All(receiving, status => Assert.Equal(contradicts ? ConnectionReason.RotationOrderMismatch : ConnectionReason.None, status.Reason));
        Assert.All(receiving, status => Assert.Contains(
            contradicts ? "rotation order YXZ, as the options say. But the stream says ZXY" : "rotation order ZXY, as the options say", status.Message, StringComparison.Ordinal));
        Assert.Equal(contradicts ? 1 : 0, lines.Count(line => line is { Id: ReaderEventId.Receiving, Level: ReaderEventLevel.Warning }));
    }

    [Fact]
    public async Task A_format_learnt_later_is_reported_and_used()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        var log = new StatusLog(reader);
        RotationOrder used = default;
        reader.MotionReceived += frame => used = frame.Format.RotationOrder;
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(Stream("new", 1));
        await log.WaitAsync(ConnectionState.Receiving);
        reader.Format.Learn(RotationOrder.XZY, variant: null);
        await log.WaitAsync(status => status.Message.EndsWith("rotation order XZY, as the command channel says.", StringComparison.Ordinal));
        await connection.SendAsync(Stream("new", 2));
        await reader.WaitForFramesAsync(2);
        Assert.Equal(RotationOrder.XZY, used);
    }

    [Fact]
    public async Task Datagrams_that_begin_within_a_line_are_recognised()
    {
        // A pause of a busy machine between two datagrams must not count as silence.
        NeuronReaderOptions options = new() { Transport = TransportKind.Udp, LocalAddress = IPAddress.Loopback, Port = 0, SilenceTimeout = TimeSpan.FromSeconds(2) };
        await using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        using FrameQueue queue = reader.OpenQueue();
        await reader.StartAsync().Soon();
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        sender.Connect(reader.Status.LocalEndPoint!);
        byte[] lines = [.. TestPackets.Line(1), .. TestPackets.Line(2, count: 946, lead: "", end: "\n"), .. TestPackets.Line(3)];
        byte[][] datagrams = [.. lines.Chunk(1024).Skip(1)];
        foreach (byte[] datagram in datagrams)
            sender.Send(datagram);

        await Limits.UntilAsync(() => queue.Count == 2);
        List<int> frames = [];
        queue.Pump<AvatarFrame>(frame => frames.Add((int)frame.Values[0]));
        Assert.Equal([2, 3], frames);
        Assert.Equal(StreamFormat.Text, (await log.WaitAsync(ConnectionState.Receiving)).Format);
        await log.WaitAsync(ConnectionState.Silent);
        Assert.DoesNotContain(log.All, status => status.Reason == ConnectionReason.UnknownFormat);
        Assert.Equal(0, reader.GetStatistics().Lost);
    }

    [Theory]
    [InlineData("0 Char00 ")]
    [InlineData("0 Anna Lena ")]
    public async Task A_lost_piece_loses_only_its_line(string lead)
    {
        await using var reader = new NeuronReader(new NeuronReaderOptions { Transport = TransportKind.Udp, LocalAddress = IPAddress.Loopback, Port = 0 });
        using FrameQueue queue = reader.OpenQueue();
        await reader.StartAsync().Soon();
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        sender.Connect(reader.Status.LocalEndPoint!);
        for (int frame = 0; frame < 6; frame++)
        {
            // Each line starts in a new datagram. The last piece of the third line is lost.
            byte[][] pieces = [.. TestPackets.Line(frame, lead: lead).Chunk(1024)];
            foreach (byte[] piece in frame == 2 ? pieces[..^1] : pieces)
                sender.Send(piece);
        }

        await Limits.UntilAsync(() => queue.Count == 5);
        List<int> frames = [];
        queue.Pump<MotionFrame>(motion => frames.Add((int)motion.Values[0]));
        Assert.Equal([0, 1, 3, 4, 5], frames);
    }

    [Fact]
    public async Task Lines_of_another_skeleton_name_the_setting()
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.SilenceTimeout = TimeSpan.FromSeconds(0.1);
        await using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        byte[] line = TestPackets.Line(1, count: 126);
        await connection.SendAsync(line);

        // On a busy machine, the connection may be silent before the line arrives.
        ConnectionStatus status = await log.WaitAsync(static status => status is { State: ConnectionState.Silent, Reason: ConnectionReason.UnknownFormat });
        Assert.Contains("180, 186, 354 or 360", status.Message, StringComparison.Ordinal);
        Assert.Contains("set Skeleton to", status.Message, StringComparison.Ordinal);
        await Limits.UntilAsync(() => reader.GetStatistics().BytesSkipped == line.Length);
    }

    [Theory]
    [InlineData("")]
    [InlineData("12.50 0.25 ||\r\n")]
    public async Task An_ambiguous_avatar_name_names_the_setting(string rest)
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.SilenceTimeout = TimeSpan.FromSeconds(0.1);
        await using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(Encoding.ASCII.GetBytes(rest), TestPackets.Line(1, lead: "0 Char 02 ")));

        // On a busy machine, the connection may be silent before the line arrives, and between the rest and the line.
        ConnectionStatus status = await log.WaitAsync(static status =>
            status is { State: ConnectionState.Silent, Reason: ConnectionReason.UnknownFormat } && status.Message.Contains("spaces and numbers", StringComparison.Ordinal));
        Assert.Contains("Rename the avatar", status.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Axis_Studio_calculation_frames_reach_every_consumer()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        int called = 0;
        reader.StudioCalculationReceived += frame => called += (int)frame.FrameIndex!;
        using FrameQueue queue = reader.OpenQueue();
        using LatestFrames latest = reader.OpenLatest();
        await using IAsyncEnumerator<StudioCalculationFrame> frames = reader.ReadStudioCalculationAsync(TestContext.Current.CancellationToken).GetAsyncEnumerator(TestContext.Current.CancellationToken);
        ValueTask<bool> first = frames.MoveNextAsync();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(TestPackets.Studio(1), TestPackets.Studio(4, avatar: 2)));
        Assert.True(await first.AsTask().Soon());
        Assert.Equal(1u, frames.Current.FrameIndex);
        Assert.True(await frames.MoveNextAsync().AsTask().Soon());
        Assert.Equal((4u, 2), (frames.Current.FrameIndex, frames.Current.AvatarIndex));
        await Limits.UntilAsync(() => Volatile.Read(ref called) == 5);

        int pumped = 0;
        Assert.Equal(2, queue.Pump<StudioCalculationFrame>(frame => pumped += (int)frame.FrameIndex!));
        Assert.Equal(5, pumped);
        Assert.True(latest.TryTakeStudioCalculation(2, out StudioCalculationFrame? newest));
        Assert.Equal(TestPackets.Value(4, 2, 13), newest.GetPosition(Bone.Hips).X);
        Assert.False(latest.TryTakeStudioCalculation(2, out _));
        Assert.False(latest.TryTakeCalculation(2, out _));

        ReaderStatistics statistics = reader.GetStatistics();
        Assert.Equal((2, 0, 0), (statistics.StudioCalculationFrames, statistics.CalculationFrames, statistics.MotionFrames));
        Assert.Equal(2 * 5020, statistics.BytesReceived);
        Assert.Equal([PacketKind.StudioCalculation, PacketKind.StudioCalculation], reader.GetAvatarStatistics().Select(avatar => avatar.Kind));
    }

    private static byte[] Stream(string name, int frame) => name switch
    {
        "new" => TestPackets.Motion(frame),
        "old" => TestPackets.Motion(frame, layout: HeaderLayout.Old),
        "text" => TestPackets.Line(frame),
        "studio" => Studio(frame),
        "calculation" => TestPackets.Calculation(frame),
        "text calculation" => TestPackets.Line(frame, count: 946, lead: "", end: "\n"),
        "studio calculation" => TestPackets.Studio(frame),
        _ => [.. TestPackets.Motion(frame), .. TestPackets.Calculation(frame)],
    };

    private static byte[] Studio(int frame)
    {
        byte[] packet = TestPackets.Motion(frame);
        packet[2] = 1; // 1.1.0.1
        packet[50] = (byte)RotationOrder.ZXY;
        return packet;
    }
}
