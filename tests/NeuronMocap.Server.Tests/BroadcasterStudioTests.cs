using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Faults;
using NeuronMocap.Tests.Server;
using static NeuronMocap.Server.Tests.Broadcasts;

namespace NeuronMocap.Server.Tests;

public sealed class BroadcasterStudioTests
{
    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate, null)]
    [InlineData(BroadcasterOptions.MaxFrameRate, 1000)]
    [InlineData(2000, null)]
    public async Task Packets_are_those_of_axis_studio(double rate, int? fragment)
    {
        BroadcasterOptions options = Options();
        options.FrameRate = rate;
        options.Fragment = fragment;
        options.RotationOrder = RotationOrder.ZXY;
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        List<byte[]> packets = await client.ReadToEndAsync();
        client.Dispose();
        await broadcaster.Completion.Soon();

        Expect.Frames(packets, options, 30);
        double framesPerSecond = double.IsInfinity(rate) ? 60 : rate;
        foreach (byte[] packet in packets)
        {
            if (!MotionHeader.TryRead(packet, out MotionHeader header))
                continue;

            Assert.Equal(4u, header.Reserved);
            Assert.Equal(StudioFrameEncoder.GetTimecode(header.FrameIndex!.Value, framesPerSecond), (header.Reserved1, header.Reserved2));
        }

        Assert.Equal((60L, 30L * 2 * (1480 + 5020)), (broadcaster.GetStatistics().FramesSent, broadcaster.GetStatistics().BytesSent));
    }

    [Fact]
    public async Task A_datagram_is_a_packet()
    {
        using var receiver = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { ReceiveBufferSize = 1_000_000 };
        receiver.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        BroadcasterOptions options = Options();

        // All datagrams at once fit into the smallest buffer that a system grants.
        options.MaxFrames = 10;
        options.WaitForClient = false;
        options.Port = null;
        options.UdpDestinations = [(IPEndPoint)receiver.LocalEndPoint!];
        await using Broadcaster broadcaster = Started(options);
        var packets = new List<byte[]>();
        byte[] buffer = new byte[65_536];
        for (int i = 0; i < 10 * 2 * 2; i++)
            packets.Add(buffer[..await receiver.ReceiveAsync(buffer.AsMemory(), TestContext.Current.CancellationToken).Soon()]);

        Expect.Frames(packets, options, 10);
    }

    [Theory]
    [InlineData(0, 60, 0x000000, 0)]
    [InlineData(59, 60, 0x000000, 59)]
    [InlineData(60, 60, 0x000001, 0)]
    [InlineData(60 * 3661 + 7, 60, 0x010101, 7)]
    [InlineData(60L * 86_400, 60, 0x000000, 0)]
    [InlineData(60L * 86_399, 60, 0x173B3B, 0)]
    [InlineData(59, 59.94, 0x000000, 59)]
    [InlineData(60, 59.94, 0x000001, 0)]
    [InlineData(119, 59.94, 0x000001, 59)]
    [InlineData(120, 59.94, 0x000002, 0)]
    [InlineData(3, 0.01, 0x000500, 0)]
    public void The_timecode_counts_from_the_first_frame(long frame, double rate, uint time, uint subFrame) =>
        Assert.Equal((time, subFrame), StudioFrameEncoder.GetTimecode(frame, rate));

    // Every second starts with frame 0, and no number within it is missing.
    [Theory]
    [InlineData(24)]
    [InlineData(29.97)]
    [InlineData(59.94)]
    [InlineData(120)]
    [InlineData(96.3)]
    public void Sub_frames_count_up_without_gaps(double rate)
    {
        (uint time, uint subFrame) previous = StudioFrameEncoder.GetTimecode(0, rate);
        Assert.Equal((0u, 0u), previous);
        for (long frame = 1; frame < 20_000; frame++)
        {
            (uint time, uint subFrame) now = StudioFrameEncoder.GetTimecode(frame, rate);
            Assert.Equal(now.time == previous.time ? previous.subFrame + 1 : 0, now.subFrame);
            previous = now;
        }
    }

    [Fact]
    public void Formats_and_settings_that_exclude_each_other_are_refused_by_name()
    {
        AssertRefused(nameof(BroadcasterOptions.DataVersion), options => options.DataVersion = DataVersion.Old);
        AssertRefused(nameof(BroadcasterOptions.DataVersion), options => (options.Format, options.DataVersion) = (BroadcastFormat.Text, DataVersion.New));
        AssertRefused(nameof(BroadcasterOptions.Calculation), options => options.Calculation = CalculationSynthesizer.Write);
        AssertRefused(nameof(BroadcasterOptions.StudioCalculation), options => options.Format = BroadcastFormat.Binary);
        AssertRefused(nameof(BroadcasterOptions.TextDecimals), options => options.TextDecimals = 7);
        AssertRefused(nameof(BroadcasterOptions.TextQuirks), options => options.TextQuirks = (TextQuirks)4);
        AssertRefused(nameof(BroadcasterOptions.Format), options => (options.Format, options.StudioCalculation) = ((BroadcastFormat)3, null));
    }

    private static void AssertRefused(string setting, Action<BroadcasterOptions> change)
    {
        BroadcasterOptions options = Options();
        change(options);
        ArgumentException exception = Assert.Throws<ArgumentException>(() => new Broadcaster(options));
        Assert.Equal(setting, exception.ParamName);
    }

    private static BroadcasterOptions Options()
    {
        BroadcasterOptions options = Expect.Options(avatars: 2, frames: 30);
        options.Sources = [.. Enumerable.Range(0, 2).Select(avatar => new SyntheticSource(60, avatar))];
        options.MaxFrames = 30;
        options.Format = BroadcastFormat.Studio;
        options.StudioCalculation = StudioCalculationSynthesizer.Write;
        options.WaitForClient = true;
        return options;
    }
}
