using System.Numerics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Server.Tests.Sources;

public class LoopedSourceTests
{
    [Fact]
    public void A_looped_source_repeats_without_end()
    {
        var looped = new LoopedSource(Climb(count: 5));
        float[] values = new float[354];

        Assert.Null(looped.FrameCount);
        Assert.Equal(60, looped.FrameRate);
        Assert.True(looped.HasDisplacement);
        foreach ((long frame, float height) in ((long, float)[])[(0, 0), (4, 4), (5, 0), (13, 3), (1_000_000_000_004, 4)])
        {
            Assert.Equal(height, ActorMeasures.GetPose(looped, frame)[0].Position.Y);
            Assert.Equal(new FootContacts((long)height % 2 == 0, (long)height % 3 == 0), looped.GetFootContacts(frame));
            looped.WriteValues(frame, new ChannelLayout(hasDisplacement: true, hasReference: false), RotationOrder.YXZ, values);
            Assert.Equal(height, values[1]);
        }
    }

    [Fact]
    public void Only_finite_sources_with_frames_can_loop()
    {
        Assert.Throws<ArgumentNullException>(() => new LoopedSource(null!));
        Assert.Throws<ArgumentException>(() => new LoopedSource(Climb(count: 0)));
        Assert.Throws<ArgumentException>(() => new LoopedSource(new SyntheticSource()));
    }

    private static FormulaSource Climb(long count) => new(
        60, count, (frame, pose) => pose[0] = new BoneTransform(new Vector3(0, frame, 0), Quaternion.Identity));
}
