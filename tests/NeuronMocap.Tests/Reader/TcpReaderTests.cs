using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

public sealed class TcpReaderTests : IDisposable
{
    private const int FrameCount = 300;

    private readonly TestServer _server = new();

    [Theory]
    [InlineData(7)]
    [InlineData(1479)]
    [InlineData(1480)]
    [InlineData(1481)]
    [InlineData(65_536)]
    [InlineData(int.MaxValue)]
    public async Task Every_frame_arrives_once_and_in_order_at_every_split(int pieceSize)
    {
        await using var reader = new NeuronReader(_server.Options());
        List<MotionFrame> called = [];
        reader.MotionReceived += frame => called.Add(frame.Clone());
        using FrameQueue queue = reader.OpenQueue();
        using LatestFrames latest = reader.OpenLatest();
        reader.Start();

        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendPiecesAsync(TestPackets.Motions(0, FrameCount), pieceSize);
        connection.Close();
        await reader.Completion.Soon();

        AssertFrames(called);
        List<MotionFrame> pumped = [];
        queue.Pump<MotionFrame>(frame => pumped.Add(frame.Clone()));
        AssertFrames(pumped);
        Assert.True(latest.TryTakeMotion(0, out MotionFrame? newest));
        Assert.Equal((uint)FrameCount - 1, newest.FrameIndex);

        ReaderStatistics statistics = reader.GetStatistics();
        Assert.Equal((FrameCount, 0L, 0L, 0L), (statistics.MotionFrames, statistics.Lost, statistics.Dropped, statistics.BytesSkipped));
        Assert.Equal(FrameCount * 1480L, statistics.BytesReceived);
        Assert.Equal(ConnectionReason.ClosedByPeer, reader.Status.Reason);
    }

    [Fact]
    public async Task Two_avatars_calculation_data_commands_and_noise_share_a_connection()
    {
        byte[] command = new byte[64];
        new DataCommandHeader { CommandId = DataCommandId.AvatarCount, DataCount = 1 }.Write(command);
        byte[] noise = [0xFF, 0xDD, 0x00, 0xFF];
        await using var reader = new NeuronReader(_server.Options());
        List<string> seen = [];
        reader.MotionReceived += frame => seen.Add($"{frame.AvatarName} {frame.AvatarIndex} {frame.FrameIndex}");
        reader.CalculationReceived += frame => seen.Add($"calculation {frame.AvatarIndex} {frame.FrameIndex}");
        reader.Start();

        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(
            noise,
            TestPackets.Motion(1, avatar: 0, name: "Alice"),
            command,
            TestPackets.Motion(7, avatar: 1, name: "Bob", count: 180),
            TestPackets.Motion(0, count: 0),
            TestPackets.Calculation(3, avatar: 1),
            noise,
            TestPackets.Motion(3, avatar: 0, name: "Alice")));
        connection.Close();
        await reader.Completion.Soon();

        Assert.Equal(["Alice 0 1", "Bob 1 7", "calculation 1 3", "Alice 0 3"], seen);
        ReaderStatistics statistics = reader.GetStatistics();
        Assert.Equal((3L, 1L, 1L, 1L), (statistics.MotionFrames, statistics.CalculationFrames, statistics.CommandPackets, statistics.EmptyPackets));
        Assert.Equal((1L, 8L), (statistics.Lost, statistics.BytesSkipped));
        Assert.Equal(
            [("Alice", PacketKind.Motion, 2L, 1L), ("Bob", PacketKind.Motion, 1L, 0L), ("Char00", PacketKind.Calculation, 1L, 0L)],
            reader.GetAvatarStatistics().Select(avatar => (avatar.AvatarName, avatar.Kind, avatar.Frames, avatar.Lost)));
    }

    [Fact]
    public async Task The_options_reach_the_frames()
    {
        NeuronReaderOptions options = _server.Options();
        options.RotationOrder = RotationOrder.ZXY;
        options.SkeletonVariant = SkeletonVariant.Spine3;
        await using var reader = new NeuronReader(options);
        var format = new TaskCompletionSource<SkeletonFormat>();
        reader.MotionReceived += frame => format.TrySetResult(frame.Format);
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        Assert.Equal(new SkeletonFormat(RotationOrder.ZXY, SkeletonVariant.Spine3), await format.Task.Soon());
    }

    [Fact]
    public async Task Packets_over_the_limit_are_skipped_and_counted()
    {
        NeuronReaderOptions options = _server.Options();
        options.MaxValues = 354;
        await using var reader = new NeuronReader(options);
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(TestPackets.Motion(1, count: 355), TestPackets.Motion(2, count: 354)));
        connection.Close();
        await reader.Completion.Soon();
        ReaderStatistics statistics = reader.GetStatistics();
        Assert.Equal((1L, 1L, 64L + (4 * 355)), (statistics.MotionFrames, statistics.OversizedPackets, statistics.BytesSkipped));
    }

    [Fact]
    public async Task Several_readers_are_independent()
    {
        NeuronReader[] readers = [.. Enumerable.Range(0, 5).Select(_ => new NeuronReader(_server.Options()))];
        foreach (NeuronReader reader in readers)
            reader.Start();

        for (int i = 0; i < readers.Length; i++)
        {
            using TestConnection connection = await _server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motions(0, 50));
            connection.Close();
        }

        foreach (NeuronReader reader in readers)
        {
            await reader.Completion.Soon();
            Assert.Equal(50, reader.GetStatistics().MotionFrames);
            await reader.DisposeAsync();
        }
    }

    [Fact]
    public async Task A_throwing_handler_is_reported_and_isolated()
    {
        await using var reader = new NeuronReader(_server.Options());
        int others = 0;
        List<string> failures = [];
        reader.MotionReceived += _ => throw new FormatException("mine");
        reader.MotionReceived += _ => others++;
        reader.StatusChanged += _ => throw new FormatException("status");
        reader.CallbackFailed += exception => failures.Add(exception.Message);
        reader.CallbackFailed += _ => throw new FormatException("the last resort");
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 10));
        connection.Close();
        await reader.Completion.Soon();

        Assert.Equal(10, others);
        Assert.Equal(10, failures.Count(message => message == "mine"));
        Assert.InRange(failures.Count(message => message == "status"), 1, int.MaxValue);
        Assert.Equal(2 * failures.Count, reader.GetStatistics().CallbackFailures);
    }

    [Fact]
    public async Task An_unpumped_queue_drops_without_blocking()
    {
        await using var reader = new NeuronReader(_server.Options());
        using FrameQueue idle = reader.OpenQueue(capacity: 8);
        FrameQueue closed = reader.OpenQueue(capacity: 16);
        using FrameQueue large = reader.OpenQueue(capacity: FrameCount);
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, FrameCount));
        connection.Close();
        await reader.Completion.Soon();
        closed.Dispose();

        Assert.Equal(FrameCount - 8, idle.Dropped);
        Assert.Equal(FrameCount, large.Pump<MotionFrame>(_ => { }));
        Assert.Equal((2 * FrameCount) - 8 - 16, reader.GetStatistics().Dropped);
    }

    [Fact]
    public async Task An_enumeration_gives_lasting_frames_and_ends_with_the_connection()
    {
        await using var reader = new NeuronReader(_server.Options());
        Task<List<MotionFrame>> reading = Task.Run(async () =>
        {
            List<MotionFrame> frames = [];
            await foreach (MotionFrame frame in reader.ReadMotionAsync())
                frames.Add(frame);

            return frames;
        });
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(TestPackets.Calculation(1), TestPackets.Motions(0, FrameCount)));
        connection.Close();
        AssertFrames(await reading.Soon());
    }

    [Fact]
    public async Task An_enumeration_ends_with_the_reason_when_the_connection_is_cut_off()
    {
        await using var reader = new NeuronReader(_server.Options());
        await using IAsyncEnumerator<MotionFrame> frames = reader.ReadMotionAsync().GetAsyncEnumerator();
        Task<bool> first = frames.MoveNextAsync().AsTask();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        Assert.True(await first.Soon());
        connection.Reset();
        NeuronConnectionException exception = await Assert.ThrowsAsync<NeuronConnectionException>(() => frames.MoveNextAsync().AsTask().Soon());
        Assert.Equal(ConnectionReason.Reset, exception.Reason);
    }

    [Fact]
    public async Task An_enumeration_that_is_cancelled_leaves_the_reader_running()
    {
        await using var reader = new NeuronReader(_server.Options());
        using var cancellation = new CancellationTokenSource();
        await using IAsyncEnumerator<CalculationFrame> frames = reader.ReadCalculationAsync(cancellation.Token).GetAsyncEnumerator();
        Task<bool> first = frames.MoveNextAsync().AsTask();
        using TestConnection connection = await _server.AcceptAsync();
        await cancellation.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => first.Soon());

        var received = new TaskCompletionSource();
        reader.MotionReceived += _ => received.TrySetResult();
        await connection.SendAsync(TestPackets.Motion(1));
        await received.Task.Soon();
    }

    [Fact]
    public async Task An_enumeration_that_is_cancelled_ends_although_frames_wait()
    {
        await using var reader = new NeuronReader(_server.Options());
        using var cancellation = new CancellationTokenSource();
        await using IAsyncEnumerator<MotionFrame> frames = reader.ReadMotionAsync(cancellation.Token).GetAsyncEnumerator();
        Task<bool> first = frames.MoveNextAsync().AsTask();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 100));
        Assert.True(await first.Soon());
        await reader.WaitForFramesAsync(100);
        await cancellation.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => frames.MoveNextAsync().AsTask().Soon());
    }

    public void Dispose() => _server.Dispose();

    private static void AssertFrames(List<MotionFrame> frames)
    {
        Assert.Equal(FrameCount, frames.Count);
        for (int i = 0; i < FrameCount; i++)
        {
            Assert.Equal((uint)i, frames[i].FrameIndex);
            Same.Items(Enumerable.Range(0, 354).Select(value => TestPackets.Value(i, 0, value)), frames[i].Values.ToArray());
        }
    }
}
