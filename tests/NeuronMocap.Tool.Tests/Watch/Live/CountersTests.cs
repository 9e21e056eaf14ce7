using NeuronMocap.Tool.Watch.Live;

namespace NeuronMocap.Tool.Tests.Watch.Live;

public sealed class CountersTests
{
    [Fact]
    public void A_reset_restarts_the_counters()
    {
        var counters = new Counters();
        counters.Reset(new ReaderStatistics { MotionFrames = 100, Lost = 7, BytesSkipped = 5 }, [new AvatarStatistics { Frames = 100, Lost = 7, Gaps = 4, Restarts = 2 }]);

        counters.Take(
            new ReaderStatistics { MotionFrames = 112, Lost = 8, BytesSkipped = 5 },
            [new AvatarStatistics { Frames = 110, Lost = 8, Gaps = 5, Restarts = 2, FrameRate = 60 }, new AvatarStatistics { AvatarIndex = 1, Frames = 2 }]);

        Assert.Equal((12, 1, 0), (counters.Total.MotionFrames, counters.Total.Lost, counters.Total.BytesSkipped));
        Assert.Equal((1, 0), (counters.Avatars[0].Gaps, counters.Avatars[0].Restarts));
        Assert.Equal([(10, 1, 60d), (2, 0, 0)], counters.Avatars.Select(avatar => (avatar.Frames, avatar.Lost, avatar.FrameRate)));
    }
}
