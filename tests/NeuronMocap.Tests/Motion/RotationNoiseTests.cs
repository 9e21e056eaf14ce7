using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Motion;

public sealed class RotationNoiseTests
{
    private const double Interval = 1 / 90.0;

    private readonly RotationNoise _noise = new();
    private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];

    [Theory]
    [InlineData(0.1, 0, true)]
    [InlineData(1, 0, false)]
    [InlineData(0.2, 90, true)]
    [InlineData(0.2, 90, false)]
    public void The_noise_of_a_steady_motion_is_measured(double degrees, double degreesPerSecond, bool even)
    {
        var random = new Random(7);
        double time = 0;
        double sum = 0;
        for (int i = 0; i < 9000; i++)
        {
            time += even ? Interval : Interval * (0.4 + (1.2 * random.NextDouble()));
            Update((degreesPerSecond * time) + (degrees * Gauss(random)), time);
            sum += i >= 900 ? _noise.GetDegrees(Bone.Head) : 0;
        }

        // The mean of one second varies, so the mean of many is compared.
        Assert.Equal(degrees, sum / 8100, 0.1 * degrees);
    }

    [Fact]
    public void Steady_motion_is_no_noise()
    {
        for (int i = 0; i < 300; i++)
            Update(i, i * Interval);

        Assert.Equal(0, _noise.GetDegrees(Bone.Head), 0.001);
    }

    [Fact]
    public void A_jump_after_a_gap_and_a_step_back_are_no_noise()
    {
        foreach (double time in (double[])[1, 1.01, 1.02, 9, 9.01, 9.02, 2, 2.01, 2.01, 2.02])
            Update(time > 5 ? 90 : 0, time);

        Assert.Equal(0, _noise.GetDegrees(Bone.Hips), 0.001);
    }

    [Fact]
    public void Reset_forgets_the_noise_and_nothing_is_allocated()
    {
        int frame = 0;
        Allocations.AssertNone(() => Update(frame % 2, frame++ * Interval));
        Assert.True(_noise.GetDegrees(Bone.Hips) > 0.1);

        _noise.Reset();
        Update(0, 0);
        Assert.Equal(0, _noise.GetDegrees(Bone.Hips));
        Assert.Throws<ArgumentException>(() => _noise.Update(new BoneTransform[3], 0));
    }

    private static double Gauss(Random random) => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());

    private void Update(double degrees, double time)
    {
        Array.Fill(_pose, new BoneTransform(Vector3.Zero, Quaternion.CreateFromAxisAngle(Vector3.UnitY, (float)(degrees * Math.PI / 180))));
        _noise.Update(_pose, time);
    }
}
