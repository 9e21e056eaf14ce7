using System.Net;
using System.Net.Sockets;
using System.Text;
using NeuronMocap.Server.Faults;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

public sealed class BroadcasterTextTests
{
    private const double Paced = 2000;

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate, null)]
    [InlineData(BroadcasterOptions.MaxFrameRate, 1024)]
    [InlineData(BroadcasterOptions.MaxFrameRate, 70_001)]
    [InlineData(Paced, null)]
    [InlineData(Paced, 7)]
    public async Task Every_line_arrives_in_order_and_the_counters_are_exact(double rate, int? fragment)
    {
        const int Frames = 60;
        BroadcasterOptions options = Options(rate, avatars: 3);
        options.MaxFrames = Frames;
        options.Fragment = fragment;
        options.Calculation = CalculationSynthesizer.Write;
        options.TextDecimals = 4;
        await using Broadcaster broadcaster = Started(options);
        string text = await TextClient.ReadToEndAsync(broadcaster.LocalEndPoint);
        await broadcaster.Completion.Soon();

        AssertLines(text, options, Frames);
        BroadcasterStatistics statistics = broadcaster.GetStatistics();
        Assert.Equal((Frames * 3L, 0L, Encoding.UTF8.GetByteCount(text)), (statistics.FramesSent, statistics.PacketsDropped, statistics.BytesSent));
    }

    [Theory]
    [InlineData((int)TextQuirks.None, "", "||\r\n", "\n")]
    [InlineData((int)TextQuirks.LineFeedOnly, "", "||\n", "\n")]
    [InlineData((int)TextQuirks.StrayZeros, "\0", "||\r\n", "\n")]
    [InlineData((int)(TextQuirks.LineFeedOnly | TextQuirks.StrayZeros), "\0", "||\n", "\n")]
    public async Task Quirks_change_the_text_around_lines(int quirks, string start, string motionEnd, string calculationEnd)
    {
        BroadcasterOptions options = Options(BroadcasterOptions.MaxFrameRate);
        options.MaxFrames = 1;
        options.Calculation = CalculationSynthesizer.Write;
        options.TextQuirks = (TextQuirks)quirks;
        options.AvatarNames = ["Ann Bell"];
        await using Broadcaster broadcaster = Started(options);
        string text = await TextClient.ReadToEndAsync(broadcaster.LocalEndPoint);

        Assert.StartsWith(start + "0 Ann_Bell ", text, StringComparison.Ordinal);
        int middle = text.IndexOf(motionEnd + start, StringComparison.Ordinal);
        Assert.True(middle > 0);
        string calculation = text[(middle + motionEnd.Length + start.Length)..];
        Assert.EndsWith(calculationEnd, calculation, StringComparison.Ordinal);
        Assert.Equal(946, TextClient.ParseColumns(calculation[..^calculationEnd.Length]).Length);
    }

    [Fact]
    public async Task A_client_that_does_not_read_loses_whole_lines_which_are_counted()
    {
        const int Avatars = 30;
        BroadcasterOptions options = Options(rate: 400, Avatars);
        options.QueueCapacity = 50;
        await using Broadcaster broadcaster = Started(options);
        using var idle = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        await idle.ConnectAsync(broadcaster.LocalEndPoint!, TestContext.Current.CancellationToken).AsTask().Soon();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().PacketsDropped >= Avatars * 20);
        await broadcaster.DisposeAsync();
        string text = await TextClient.ReadToEndAsync(idle);

        // When the broadcast stops, its data may end in the middle of a line.
        string[] lines = text.Split("\r\n")[..^1];
        Assert.True(lines.Length >= Avatars);
        long previous = -1;
        for (int i = 0; i + Avatars <= lines.Length; i += Avatars)
        {
            long frame = FindFrame(options, lines[i], previous + 1);
            Assert.All(lines[i..(i + Avatars)], (line, avatar) => AssertMotion(line, options, avatar, frame));
            previous = frame;
        }
    }

    [Theory]
    [InlineData(null)]
    [InlineData(1024)]
    public async Task A_datagram_is_a_line_or_a_piece_of_one(int? fragment)
    {
        using var receiver = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { ReceiveBufferSize = 1_000_000 };
        receiver.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        BroadcasterOptions options = Options(BroadcasterOptions.MaxFrameRate, avatars: 2);
        options.Port = null;
        options.UdpDestinations = [(IPEndPoint)receiver.LocalEndPoint!];
        options.MaxFrames = 10;
        options.Fragment = fragment;
        options.Calculation = CalculationSynthesizer.Write;
        await using Broadcaster broadcaster = Started(options);
        var text = new StringBuilder();
        byte[] buffer = new byte[65_536];
        for (int line = 0; line < 10 * 2 * 2; line++)
        {
            int count;
            do
            {
                count = await receiver.ReceiveAsync(buffer.AsMemory(), TestContext.Current.CancellationToken).Soon();
                string piece = Encoding.UTF8.GetString(buffer, 0, count);
                Assert.True(piece.IndexOf('\n') is var end && (end < 0 || end == piece.Length - 1));
                Assert.True(fragment is null ? end >= 0 : count == fragment || (count < fragment && end >= 0));
                text.Append(piece);
            }
            while (buffer[count - 1] != '\n');
        }

        AssertLines(text.ToString(), options, 10);
        await broadcaster.Completion.Soon();
        Assert.Equal((20L, text.Length), (broadcaster.GetStatistics().FramesSent, broadcaster.GetStatistics().BytesSent));
    }

    [Fact]
    public async Task Values_that_text_cannot_express_keep_lines_short()
    {
        BroadcasterOptions options = Expect.Options(avatars: 2, frames: 20);
        options.Format = BroadcastFormat.Text;
        await using Broadcaster broadcaster = Started(options);
        string text = await TextClient.ReadToEndAsync(broadcaster.LocalEndPoint);
        string[] lines = text.Split("\r\n", StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(40, lines.Length);
        Assert.All(lines, line => Assert.Equal(354, TextClient.ParseMotion(line).Values.Length));
    }

    private static BroadcasterOptions Options(double rate, int avatars = 1) => new()
    {
        Sources = [.. Enumerable.Range(0, avatars).Select(avatar => new SyntheticSource(60, avatar))],
        Port = 0,
        FrameRate = rate,
        Format = BroadcastFormat.Text,
        WaitForClient = true,
        QueueCapacity = 10_000,
        CloseTimeout = Limits.Unexpected,
    };

    private static Broadcaster Started(BroadcasterOptions options)
    {
        options.WaitForClient &= options.Port is not null;
        var broadcaster = new Broadcaster(options);
        broadcaster.Start();
        return broadcaster;
    }

    private static void AssertLines(string text, BroadcasterOptions options, int frames)
    {
        string[] lines = text.Split('\n');
        int index = 0;
        for (int frame = 0; frame < frames; frame++)
        {
            for (int avatar = 0; avatar < options.Sources.Count; avatar++)
            {
                Assert.EndsWith("||\r", lines[index], StringComparison.Ordinal);
                AssertMotion(lines[index++][..^1], options, avatar, frame);
                float[] calculation = new float[946];
                options.Calculation!(options.Sources[avatar], frame, calculation);
                AssertClose(calculation, TextClient.ParseColumns(lines[index++]), options);
            }
        }

        Assert.Equal([""], lines[index..]);
    }

    private static void AssertMotion(string line, BroadcasterOptions options, int avatar, long frame)
    {
        (int number, string name, double[] values) = TextClient.ParseMotion(line);
        Assert.Equal((avatar, $"Char{avatar:00}"), (number, name));
        AssertClose(GetValues(options, avatar, frame), values, options);
    }

    private static float[] GetValues(BroadcasterOptions options, int avatar, long frame)
    {
        float[] values = new float[354];
        options.Sources[avatar].WriteValues(frame, new ChannelLayout(hasDisplacement: true, hasReference: false), RotationOrder.YXZ, values);
        return values;
    }

    private static void AssertClose(float[] expected, double[] actual, BroadcasterOptions options)
    {
        double tolerance = (0.5 * Math.Pow(10, -options.TextDecimals)) + 1e-9;
        Assert.Equal(expected.Length, actual.Length);
        for (int i = 0; i < expected.Length; i++)
            Assert.InRange(actual[i] - expected[i], -tolerance, tolerance);
    }

    // The lines carry no number, but no two frames of the actor are equal.
    private static long FindFrame(BroadcasterOptions options, string line, long first)
    {
        double[] values = TextClient.ParseMotion(line).Values;
        for (long frame = first; ; frame++)
        {
            float[] candidate = GetValues(options, 0, frame);
            if (values.Zip(candidate).All(pair => Math.Abs(pair.First - pair.Second) <= 0.0051))
                return frame;

            Assert.True(frame < first + 20_000);
        }
    }
}
