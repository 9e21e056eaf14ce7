using NeuronMocap.Server;

namespace NeuronMocap.Tests.Server;

public sealed class DemoTests
{
    [Fact]
    public async Task A_demo_sends_every_avatar_from_the_first_frame()
    {
        await using Broadcaster demo = Broadcaster.StartDemo(avatars: 2, frameRate: 240);
        Assert.Equal(240, demo.Rate);
        await using var reader = new NeuronReader(NeuronReaderOptions.Parse($"{demo.LocalEndPoint}"));
        List<(string, uint?)> frames = [];
        await foreach (MotionFrame frame in reader.ReadMotionAsync(TestContext.Current.CancellationToken))
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

    [Theory]
    [InlineData(0, 60)]
    [InlineData(257, 60)]
    [InlineData(1, 0)]
    public void A_demo_out_of_range_is_refused(int avatars, double frameRate) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => Broadcaster.StartDemo(avatars, frameRate));
}
