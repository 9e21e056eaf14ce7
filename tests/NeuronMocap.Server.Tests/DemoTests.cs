using NeuronMocap.Commands;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Server;

public sealed class DemoTests
{
    [Fact]
    public async Task A_demo_sends_every_avatar_from_the_first_frame()
    {
        await using Broadcaster demo = Broadcaster.StartDemo(avatars: 2, frameRate: 240);
        Assert.Equal(240, demo.FrameRate);
        await using var reader = new NeuronReader(NeuronReaderOptions.Parse($"{demo.LocalEndPoint}"));
        List<(string, uint?)> frames = [];
        await foreach (MotionFrame frame in reader.ReadMotionAsync(new FrameQueueOptions { Capacity = 4096 }, TestContext.Current.CancellationToken))
        {
            frames.Add((frame.AvatarName, frame.FrameIndex));
            if (frames.Count == 4)
                break;
        }

        uint? first = frames[0].Item2;
        Assert.Equal([("Demo 1", first), ("Demo 2", first), ("Demo 1", first + 1), ("Demo 2", first + 1)], frames);
        Assert.InRange(first!.Value, 0u, 1u);
        await reader.DisposeAsync();
        ReaderStatistics statistics = reader.GetStatistics();
        Assert.Equal(statistics.MotionFrames, statistics.Frames);
        Assert.InRange(statistics.Frames, 4, long.MaxValue);
    }

    [Fact]
    public async Task A_command_server_answers_for_the_avatars_of_a_demo()
    {
        await using Broadcaster demo = Broadcaster.StartDemo(avatars: 2, rotationOrder: RotationOrder.ZXY);
        await using var server = new CommandServer(demo, new CommandServerOptions { Port = 0 });
        server.Start();
        NeuronCommandOptions options = NeuronCommandOptions.Parse($"{server.LocalEndPoint}");
        options.Timeout = Limits.Unexpected;
        await using var client = new NeuronCommandClient(options);

        Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync(TestContext.Current.CancellationToken));
        BoneDimensions body = await client.GetBoneDimensionsAsync(1, TestContext.Current.CancellationToken);
        Assert.True(body.UpperLeg > 0);
        Assert.Contains("ROOT Hips", await client.GetBvhHeaderTextAsync(1, TestContext.Current.CancellationToken), StringComparison.Ordinal);
        await Assert.ThrowsAsync<NeuronCommandException>(() => client.GetBoneDimensionsAsync(2, TestContext.Current.CancellationToken));
    }

    [Theory]
    [InlineData(0, 60)]
    [InlineData(257, 60)]
    [InlineData(1, 0)]
    [InlineData(1, 0.009)]
    [InlineData(1, 1e6)]
    [InlineData(1, double.NaN)]
    [InlineData(1, BroadcasterOptions.MaxFrameRate)]
    [InlineData(1, 60, 6)]
    [InlineData(1, 60, -1)]
    public void A_demo_out_of_range_is_refused(int avatars, double frameRate, int order = 0)
    {
        string name = order != 0 ? "rotationOrder" : avatars != 1 ? "avatars" : "frameRate";
        Assert.Throws<ArgumentOutOfRangeException>(name, () => Broadcaster.StartDemo(avatars, frameRate, (RotationOrder)order));
    }
}
