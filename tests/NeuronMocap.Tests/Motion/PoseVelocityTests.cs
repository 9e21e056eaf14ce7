using System.Numerics;
using NeuronMocap.Motion;

namespace NeuronMocap.Tests.Motion;

public sealed class PoseVelocityTests
{
    private static readonly Vector3 Axis = Vector3.Normalize(new Vector3(1, -2, 0.5f));

    [Theory]
    [InlineData(0.01, 0.01)]
    [InlineData(0.02, 0.005)]
    [InlineData(0.003, 0.021)]
    public void Central_differences_are_exact_for_constant_acceleration_at_any_spacing(double before, double after)
    {
        var velocities = new BoneVelocity[1];
        foreach (double time in (double[])[-0.7, 0, 0.4])
        {
            PoseVelocity.ComputeCentral(At(time - before), At(time), At(time + after), before, after, velocities);
            AssertNear(VelocityAt(time), velocities[0].Linear, 0.2f);
            AssertNear(TurnAt(time), velocities[0].Angular, 0.02f);
        }
    }

    [Fact]
    public void Backward_differences_are_the_velocity_halfway()
    {
        var velocities = new BoneVelocity[1];
        PoseVelocity.ComputeBackward(At(0.30), At(0.31), 0.01, velocities);
        AssertNear(VelocityAt(0.305), velocities[0].Linear, 0.05f);
        AssertNear(TurnAt(0.305), velocities[0].Angular, 0.01f);
    }

    [Fact]
    public void The_sign_of_a_quaternion_is_no_rotation()
    {
        BoneTransform[] one = At(0.30);
        BoneTransform[] other = [one[0] with { Rotation = Quaternion.Negate(one[0].Rotation) }];
        var velocities = new BoneVelocity[1];
        PoseVelocity.ComputeBackward(one, other, 0.01, velocities);
        Assert.True(velocities[0].Angular.Length() < 0.1f, $"{velocities[0].Angular}");
    }

    [Fact]
    public void Frames_at_one_time_have_no_velocity()
    {
        var velocities = new BoneVelocity[1];
        PoseVelocity.ComputeBackward(At(0), At(1), 0, velocities);
        Assert.Equal(default, velocities[0]);

        // The first frame of a take is its own predecessor, so only the difference to the next frame remains.
        PoseVelocity.ComputeCentral(At(0), At(0), At(0.01), 0, 0.01, velocities);
        AssertNear(VelocityAt(0.005), velocities[0].Linear, 0.1f);
        PoseVelocity.ComputeCentral(At(0), At(0), At(0), 0, 0, velocities);
        Assert.Equal(default, velocities[0]);
    }

    [Fact]
    public void Short_spans_are_refused_and_nothing_is_allocated()
    {
        BoneTransform[] pose = At(0);
        var velocities = new BoneVelocity[1];
        Allocations.AssertNone(() => PoseVelocity.ComputeCentral(pose, pose, pose, 1, 1, velocities));
        Assert.Throws<ArgumentException>(() => PoseVelocity.ComputeBackward(pose, pose, 1, []));
        Assert.Throws<ArgumentException>(() => PoseVelocity.ComputeBackward([], pose, 1, velocities));
        Assert.Throws<ArgumentException>(() => PoseVelocity.ComputeCentral(pose, pose, [], 1, 1, velocities));
    }

    // A body that is thrown and turns faster and faster.
    private static BoneTransform[] At(double time) =>
    [
        new BoneTransform(
            new Vector3((float)(50 * time), (float)((200 * time) - (490.5 * time * time)), 10),
            Quaternion.CreateFromAxisAngle(Axis, (float)((2 * time) + (1.5 * time * time)))),
    ];

    private static Vector3 VelocityAt(double time) => new(50, (float)(200 - (981 * time)), 0);

    private static Vector3 TurnAt(double time) => Axis * (float)(2 + (3 * time));

    private static void AssertNear(Vector3 expected, Vector3 actual, float tolerance) =>
        Assert.True(Vector3.Distance(expected, actual) < tolerance, $"Expected {expected}, found {actual}.");
}
