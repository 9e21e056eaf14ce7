using NeuronMocap.Tests.Server;
using static NeuronMocap.Server.Tests.Broadcasts;

namespace NeuronMocap.Server.Tests;

public sealed class BroadcasterMaxRateTests
{
    public static MatrixTheoryData<bool, bool, RotationOrder, bool> Formats { get; } =
        new([false, true], [false, true], Enum.GetValues<RotationOrder>(), [false, true]);

    [Theory]
    [InlineData(null, 500)]
    [InlineData(1, 12)]
    [InlineData(7, 60)]
    [InlineData(1480, 200)]
    [InlineData(1481, 200)]
    [InlineData(65_536, 500)]
    public async Task A_client_gets_the_exact_take_in_pieces_of_any_size(int? fragment, int frames)
    {
        BroadcasterOptions options = Expect.Options(frames: frames);
        options.Fragment = fragment;
        Expect.Frames(await BroadcastAsync(options), options, frames);
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public async Task Every_format_arrives_bit_for_bit(bool displacement, bool reference, RotationOrder order, bool isOld)
    {
        BroadcasterOptions options = Expect.Options(frames: 3);
        options.IncludeDisplacement = displacement;
        options.IncludeReference = reference;
        options.RotationOrder = order;
        options.DataVersion = isOld ? DataVersion.Old : DataVersion.New;
        Expect.Frames(await BroadcastAsync(options), options, 3);
    }

    // A name of full length has bytes wherever a field of the other layout is.
    [Theory]
    [InlineData(false, null)]
    [InlineData(false, 70)]
    [InlineData(true, null)]
    [InlineData(true, 70)]
    public async Task Every_header_is_the_avatars_own(bool isOld, int? fragment)
    {
        BroadcasterOptions options = Expect.Options(avatars: 2, frames: 5);
        options.DataVersion = isOld ? DataVersion.Old : DataVersion.New;
        options.AvatarNames = [new string('A', 31), new string('B', 31)];
        options.Fragment = fragment;
        Expect.Frames(await BroadcastAsync(options), options, 5);
    }

    [Theory]
    [InlineData(1, 946, null)]
    [InlineData(3, 946, null)]
    [InlineData(3, 338, 1000)]
    [InlineData(30, 946, 70_001)]
    public async Task Calculation_packets_follow_the_motion_packets_of_their_avatars(int avatars, int values, int? fragment)
    {
        BroadcasterOptions options = Expect.Options(avatars, frames: 40);
        options.Calculation = TestSource.WriteCalculation;
        options.CalculationValueCount = values;
        options.Fragment = fragment;
        Expect.Frames(await BroadcastAsync(options), options, 40);
    }

    [Fact]
    public async Task Axis_studio_writes_its_rotation_order_into_the_header()
    {
        BroadcasterOptions options = Expect.Options(frames: 1);
        options.DataVersion = DataVersion.Studio;
        options.RotationOrder = RotationOrder.ZXY;
        options.AvatarNames = ["演员"];
        List<byte[]> packets = await BroadcastAsync(options);

        Expect.Frames(packets, options, 1);
        Assert.True(MotionHeader.TryRead(packets[0], out MotionHeader header));
        Assert.Equal(4u, header.Reserved);
    }

    [Fact]
    public async Task A_slow_client_loses_nothing_and_delays_nobody()
    {
        const int Frames = 3000;
        BroadcasterOptions options = Expect.Options(frames: Frames);
        options.CloseTimeout = TimeSpan.FromMinutes(10);
        await using Broadcaster broadcaster = Started(options);
        using TestClient slow = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        byte[]? first = await slow.ReadAsync();
        using TestClient fast = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        using TestClient other = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);

        // The slow client has read one frame when the others have read all.
        List<byte[]>[] whole = await Task.WhenAll(fast.ReadToEndAsync(), other.ReadToEndAsync());
        List<byte[]> rest = await slow.ReadToEndAsync(async () => await Task.Yield());

        Assert.All(whole, packets => Expect.Frames(packets, options, Frames));
        Expect.Frames([first!, .. rest], options, Frames);
        fast.Dispose();
        other.Dispose();
        Assert.False(broadcaster.Completion.IsCompleted);
        slow.Dispose();
        await broadcaster.Completion.Soon();
        BroadcasterStatistics statistics = broadcaster.GetStatistics();
        Assert.Equal(3, statistics.Accepted);
        Assert.Equal(0, statistics.Clients);
        Assert.Equal(3 * Frames, statistics.FramesSent);
        Assert.Equal(3 * Frames * 1480L, statistics.BytesSent);
        Assert.Equal(0, statistics.PacketsDropped);
    }

    [Fact]
    public async Task A_client_that_leaves_early_does_not_end_the_broadcast()
    {
        BroadcasterOptions options = Expect.Options(frames: 20_000);
        await using Broadcaster broadcaster = Started(options);
        using (TestClient leaver = await TestClient.ConnectAsync(broadcaster.LocalEndPoint))
            Expect.Motion((await leaver.ReadAsync())!, options, avatar: 0, frame: 0);

        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 0);
        Assert.False(broadcaster.Completion.IsCompleted);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        Assert.Equal(20_000, (await client.ReadToEndAsync()).Count);
    }

    [Fact]
    public async Task The_frame_limit_ends_an_endless_source()
    {
        BroadcasterOptions options = Expect.Options();
        options.MaxFrames = 17;
        Expect.Frames(await BroadcastAsync(options), options, 17);
    }

    [Fact]
    public async Task The_shortest_source_ends_the_broadcast()
    {
        BroadcasterOptions options = Expect.Options();
        options.Sources = [new TestSource(0, 9), new TestSource(1, 5), new TestSource(2)];
        options.MaxFrames = 100;
        Expect.Frames(await BroadcastAsync(options), options, 5);
    }

    private static async Task<List<byte[]>> BroadcastAsync(BroadcasterOptions options)
    {
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        List<byte[]> packets = await client.ReadToEndAsync();
        client.Dispose();
        await broadcaster.Completion.Soon();
        return packets;
    }
}
