using System.Diagnostics;
using NeuronMocap.Server.Osc;

namespace NeuronMocap.Server.Tests.Osc;

public sealed class AvatarPosesTests
{
    [Fact]
    public void The_newest_frame_of_each_avatar_stays()
    {
        var poses = new AvatarPoses(new AvatarChoice(null, null, onlyOne: false));
        poses.Take(Poses.Frame(1));
        poses.Take(Poses.Frame(2, avatar: 1, name: "Bob"));
        poses.Take(Poses.Frame(3));
        poses.Take(new MotionFrame(new MotionHeader(), new float[7]));
        Assert.Equal([(0, "Ann", 3u), (1, "Bob", 2u)], poses.All.Select(static pose => (pose.Index, pose.Name, pose.FrameIndex!.Value)));
        Assert.Equal((1, 1), (poses.Replaced, poses.Ignored));
        Assert.All(poses.All, static pose => Assert.True(pose.IsPending));
    }

    [Fact]
    public void Avatars_without_end_take_bounded_memory()
    {
        var poses = new AvatarPoses(new AvatarChoice(null, null, onlyOne: false));
        for (int avatar = 0; avatar < 300; avatar++)
            poses.Take(Poses.Frame(1, avatar, count: 180));

        Assert.Equal(256, poses.All.Count);
        Assert.Equal(299, poses.All[^1].Index);
        Assert.Equal(44, poses.Replaced);
    }

    [Theory]
    [InlineData(null, null, 4)]
    [InlineData(1, null, 2)]
    [InlineData(null, "Ann", 2)]
    [InlineData(1, "Ann", 1)]
    [InlineData(null, "ann", 0)]
    public void Number_and_name_choose_avatars(int? index, string? name, int expected)
    {
        var choice = new AvatarChoice(index, name, onlyOne: false);
        MotionFrame[] frames = [Poses.Frame(1, 0, "Ann"), Poses.Frame(1, 1, "Ann"), Poses.Frame(1, 1, "Bob"), Poses.Frame(1, 2, "Bob")];
        Assert.Equal(expected, frames.Count(choice.Takes));
    }

    [Fact]
    public void Another_performer_takes_over_only_after_two_seconds_of_silence()
    {
        var choice = new AvatarChoice(null, null, onlyOne: true);
        long second = Stopwatch.Frequency;
        Assert.True(choice.IsTheOne(0, 3, 0));
        Assert.False(choice.IsTheOne(0, 4, second));
        Assert.True(choice.IsTheOne(0, 3, second));
        Assert.False(choice.IsTheOne(1, 3, (3 * second) - 1));
        Assert.True(choice.IsTheOne(1, 3, 3 * second));
        Assert.False(choice.IsTheOne(0, 3, 3 * second));
    }
}
