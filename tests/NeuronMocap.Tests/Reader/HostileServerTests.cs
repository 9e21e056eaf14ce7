using System.Buffers.Binary;
using NeuronMocap.Protocol;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

// A real broadcast that sends every client all frames from 0 on, through a proxy that disturbs the connection.
public abstract class HostileServerTests
{
    private const int Frames = 100;
    private const int FrameSize = 1480;

    internal abstract TcpReceiver CreateReceiver();

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(63)]
    [InlineData(64)]
    [InlineData(700)]
    [InlineData(1479)]
    public async Task A_reset_within_a_frame_loses_only_that_frame(int cut)
    {
        NeuronReader? reader = null;
        await using Broadcaster broadcaster = Started();
        await using var proxy = new FaultProxy(broadcaster.LocalEndPoint!, async link =>
        {
            if (link.Number == 0)
            {
                await link.ForwardAsync((10 * FrameSize) + cut);

                // A reset discards data that the other side has not read.
                await Limits.UntilAsync(() => reader!.GetStatistics().MotionFrames == 10);
                link.Reset();
                return;
            }

            await link.ForwardAsync(Frames * FrameSize);
            await link.HoldAsync();
        });
        reader = CreateReader(Options(proxy));
        await using NeuronReader disposing = reader;
        var log = new StatusLog(reader);
        List<uint?> indices = Indices(reader);
        reader.Start();
        await reader.WaitForFramesAsync(10 + Frames);

        Assert.Equal(Enumerable.Range(0, 10).Concat(Enumerable.Range(0, Frames)).Select(i => (uint?)i), indices);
        Assert.Equal(ConnectionReason.Reset, (await log.WaitAsync(ConnectionState.Waiting)).Reason);
        Assert.Equal((1L, 0L), (reader.GetStatistics().Reconnects, reader.GetStatistics().Lost));

        // The part of the cut frame that was read before the reset.
        Assert.InRange(reader.GetStatistics().BytesSkipped, 0, cut);
    }

    [Fact]
    public async Task A_half_closed_connection_delivers_everything_before_the_end()
    {
        await using Broadcaster broadcaster = Started();
        await using var proxy = new FaultProxy(broadcaster.LocalEndPoint!, async link =>
        {
            await link.ForwardAsync((10 * FrameSize) + 700);
            link.HalfClose();
            await link.HoldAsync();
        });
        NeuronReaderOptions options = Options(proxy);
        options.Reconnect.Enabled = false;
        await using var reader = CreateReader(options);
        reader.Start();
        await reader.Completion.Soon();

        Assert.Equal(ConnectionReason.ClosedByPeer, reader.Status.Reason);
        Assert.Equal((10L, 700L), (reader.GetStatistics().MotionFrames, reader.GetStatistics().BytesSkipped));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(61)]
    public async Task A_slow_stream_loses_nothing(int pieceSize)
    {
        await using Broadcaster broadcaster = Started();
        await using var proxy = new FaultProxy(broadcaster.LocalEndPoint!, async link =>
        {
            await link.ForwardAsync(10 * FrameSize, pieceSize);
            await link.HoldAsync();
        });
        await using var reader = CreateReader(Options(proxy));
        List<uint?> indices = Indices(reader);
        reader.Start();
        await reader.WaitForFramesAsync(10);

        Assert.Equal(Enumerable.Range(0, 10).Select(i => (uint?)i), indices);
        Assert.Equal((0L, 0L, 10L * FrameSize), (reader.GetStatistics().BytesSkipped, reader.GetStatistics().Lost, reader.GetStatistics().BytesReceived));
    }

    [Fact]
    public async Task Pauses_are_reported_and_lose_nothing()
    {
        NeuronReader? told = null;
        await using Broadcaster broadcaster = Started();
        await using var proxy = new FaultProxy(broadcaster.LocalEndPoint!, async link =>
        {
            await link.ForwardAsync(5 * FrameSize);
            await SilenceAsync(5);
            await link.ForwardAsync((5 * FrameSize) + 700);
            await SilenceAsync(10);
            await link.ForwardAsync((90 * FrameSize) - 700);
            await link.HoldAsync();
        });
        await using NeuronReader reader = told = CreateReader(Options(proxy));
        var log = new StatusLog(reader);
        List<uint?> indices = Indices(reader);
        reader.Start();
        await reader.WaitForFramesAsync(Frames);

        // A thread that still reports a silence also reports what comes after it, which can be later than the frames. A busy machine may cause further pauses.
        await Limits.UntilAsync(() => Count(ConnectionState.Receiving) >= 3 && Count(ConnectionState.Silent) >= 2);

        Assert.Equal(Enumerable.Range(0, Frames).Select(i => (uint?)i), indices);
        Assert.Equal([ConnectionState.Connecting, ConnectionState.Connected], log.All.Take(2).Select(static status => status.State));
        Assert.All(log.All.Where(status => status.State == ConnectionState.Silent), status => Assert.Equal(ConnectionReason.NoData, status.Reason));
        Assert.Equal((0L, 0L), (reader.GetStatistics().BytesSkipped, reader.GetStatistics().Reconnects));

        int Count(ConnectionState state) => log.All.Count(status => status.State == state);
        Task SilenceAsync(int frames) => Limits.UntilAsync(() => told!.GetStatistics().MotionFrames == frames && told.Status.State == ConnectionState.Silent);
    }

    [Fact]
    public async Task Lost_and_inserted_bytes_lose_only_the_frames_they_hit()
    {
        byte[] noise = [.. Enumerable.Repeat((byte)0xFF, 1000)];
        await using Broadcaster broadcaster = Started();
        await using var proxy = new FaultProxy(broadcaster.LocalEndPoint!, async link =>
        {
            await link.ForwardAsync(10 * FrameSize);
            await link.DropAsync(100);
            await link.ForwardAsync((10 * FrameSize) - 100);
            await link.InjectAsync(noise);
            await link.ForwardAsync(80 * FrameSize);
            await link.HoldAsync();
        });
        await using var reader = CreateReader(Options(proxy));
        List<uint?> indices = Indices(reader);
        reader.Start();
        await reader.WaitForFramesAsync(Frames - 1);

        Assert.Equal(Enumerable.Range(0, Frames).Where(i => i != 10).Select(i => (uint?)i), indices);
        Assert.Equal((1380L + noise.Length, 1L), (reader.GetStatistics().BytesSkipped, reader.GetStatistics().Lost));
    }

    [Fact]
    public async Task Counts_of_four_billion_are_refused_at_once()
    {
        byte[] calculation = TestPackets.Calculation(1, count: 0);
        calculation.AsSpan(6, 4).Fill(0xFF);
        byte[] command = new byte[64];
        new DataCommandHeader { CommandId = DataCommandId.BoneSize, DataCount = uint.MaxValue }.Write(command);
        byte[] motion = TestPackets.Motion(1, count: 0);
        BinaryPrimitives.WriteUInt16LittleEndian(motion.AsSpan(6), ushort.MaxValue);
        byte[][] hostile = [calculation, command, motion];

        await using Broadcaster broadcaster = Started();
        await using var proxy = new FaultProxy(broadcaster.LocalEndPoint!, async link =>
        {
            for (int frame = 0; frame < Frames; frame++)
            {
                await link.ForwardAsync(FrameSize);
                await link.InjectAsync(hostile[frame % hostile.Length]);
            }

            await link.HoldAsync();
        });
        await using var reader = CreateReader(Options(proxy));
        List<uint?> indices = Indices(reader);
        reader.Start();
        await reader.WaitForFramesAsync(Frames);
        await reader.UntilAsync(static statistics => statistics is { BytesSkipped: Frames * 64, OversizedPackets: Frames });

        Assert.Equal(Enumerable.Range(0, Frames).Select(i => (uint?)i), indices);
        Assert.Equal((long)Frames, reader.GetStatistics().OversizedPackets);
        Assert.Equal((0L, 0L), (reader.GetStatistics().Lost, reader.GetStatistics().CommandPackets));
    }

    private static Broadcaster Started()
    {
        var broadcaster = new Broadcaster(Expect.Options());
        broadcaster.Start();
        return broadcaster;
    }

    private NeuronReader CreateReader(NeuronReaderOptions options) => options.CreateReader(CreateReceiver);

    private static NeuronReaderOptions Options(FaultProxy proxy) => new()
    {
        Port = proxy.Port,
        SilenceTimeout = TimeSpan.FromMilliseconds(100),
        Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(5) },
    };

    private static List<uint?> Indices(NeuronReader reader)
    {
        List<uint?> indices = [];
        reader.MotionReceived += frame => indices.Add(frame.FrameIndex);
        return indices;
    }
}

public sealed class BlockingHostileServerTests : HostileServerTests
{
    internal override TcpReceiver CreateReceiver() => new BlockingTcpReceiver();
}
