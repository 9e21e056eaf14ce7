using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Motion;

// Tags are ten times the frame number.
public sealed class PoseBufferTagTests
{
    private readonly PoseBuffer _buffer = new(new PoseBufferOptions
    {
        Delay = TimeSpan.Zero,
        MaxExtrapolation = TimeSpan.Zero,
        Interpolation = PoseInterpolationMethod.Linear,
        Capacity = 128,
    });

    private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];

    [Fact]
    public void A_pose_between_frames_has_the_tag_of_the_earlier_one()
    {
        for (int i = 1; i <= 20; i++)
            Push(i, i * 0.01);

        Assert.Equal((10, PoseOrigin.First), SampleAt(0.005));
        Assert.Equal((90, PoseOrigin.Interpolated), SampleAt(0.091));
        Assert.Equal((90, PoseOrigin.Interpolated), SampleAt(0.099));
        Assert.Equal((100, PoseOrigin.Interpolated), SampleAt(0.101));
        Assert.Equal((200, PoseOrigin.Held), SampleAt(1));
    }

    [Fact]
    public void Frames_that_arrive_together_keep_their_tags()
    {
        for (int i = 1; i <= 60; i++)
            Push(i, i * 0.01);

        // A stall of 100 ms.
        for (int i = 61; i <= 70; i++)
            Push(i, 0.7);

        var shown = new SortedSet<long>();
        for (double time = 0.601; time < 0.9; time += 0.0005)
        {
            (long tag, _) = SampleAt(time);
            Assert.InRange(_pose[0].Position.X - (tag / 10), -1e-3, 1.001);
            shown.Add(tag);
        }

        Assert.Equal((600, 700), (shown.Min, shown.Max));
        Assert.True(shown.Count >= 5, string.Join(", ", shown));
    }

    private (long Tag, PoseOrigin Origin) SampleAt(double seconds)
    {
        PoseOrigin origin = _buffer.Sample(seconds, _pose);
        return (_buffer.SampledTag, origin);
    }

    private void Push(int number, double arrival)
    {
        _pose.AsSpan().Fill(new BoneTransform(new Vector3(number, 0, 0), Quaternion.Identity));
        Assert.True(_buffer.Push(_pose, arrival, (uint)number, 10 * number));
    }
}
