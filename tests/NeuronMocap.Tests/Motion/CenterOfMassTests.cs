using System.Numerics;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Motion;

public sealed class CenterOfMassTests
{
    [Fact]
    public void The_segments_weigh_as_much_as_the_body() => Assert.Equal(1, CenterOfMass.WholeMass, 1e-6f);

    // In the literature, it is at 55 to 57 % of the stature for standing with arms down. Raised arms raise it.
    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void A_standing_body_has_it_above_half_its_height(SkeletonVariant variant)
    {
        BoneTransform[] pose = Rest(variant);
        float stature = 161.1f;
        Vector3 armsOut = Compute(pose, variant);
        foreach ((Bone arm, float degrees) in ((Bone, float)[])[(Bone.RightArm, 90), (Bone.LeftArm, -90)])
            pose[(int)arm] = pose[(int)arm] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, degrees * MathF.PI / 180) };
        Vector3 armsDown = Compute(pose, variant);

        Assert.Equal(0, armsOut.X, 1e-3f);
        Assert.Equal(0, armsDown.X, 1e-3f);
        Assert.InRange(armsDown.Z, -1, 1);
        Assert.InRange(armsDown.Y / stature, 0.54f, 0.59f);
        Assert.True(armsOut.Y > armsDown.Y + 2, $"{armsOut.Y} and {armsDown.Y}");
    }

    [Fact]
    public void The_center_of_mass_moves_with_the_body()
    {
        BoneTransform[] pose = Rest(SkeletonVariant.Neck1);
        Vector3 before = Compute(pose, SkeletonVariant.Neck1);
        var move = new BoneTransform(new Vector3(10, -20, 30), EulerAngles.ToQuaternion(new Vector3(40, 50, 60), RotationOrder.YXZ));
        pose[0] = move.Apply(pose[0]);
        Assert.True(Vector3.Distance(move.TransformPoint(before), Compute(pose, SkeletonVariant.Neck1)) < 1e-3f);
    }

    [Fact]
    public void A_raised_leg_moves_it_by_the_legs_share()
    {
        BoneTransform[] pose = Rest(SkeletonVariant.Neck1);
        Vector3 before = Compute(pose, SkeletonVariant.Neck1);
        pose[(int)Bone.LeftUpLeg] = pose[(int)Bone.LeftUpLeg] with { Position = pose[(int)Bone.LeftUpLeg].Position + new Vector3(0, 10, 0) };
        float expected = 10 * (0.1416f + 0.0433f + 0.0137f);

        // Seen from the lower end of the trunk, half of the hip's movement belongs to the trunk.
        Vector3 moved = Compute(pose, SkeletonVariant.Neck1) - before;
        Assert.InRange(moved.Y, expected, expected + 1.5f);
    }

    [Fact]
    public void An_actor_keeps_it_between_standing_feet()
    {
        // The stops in a programme of forty seconds: both feet planted for a second or more.
        var actor = new SyntheticSource(60);
        BoneTransform[] pose = new BoneTransform[59];
        int planted = 0;
        int tested = 0;
        for (int frame = 0; frame < 2400; frame++)
        {
            planted = actor.GetFootContacts(frame) is (true, true) ? planted + 1 : 0;
            if (planted < 60)
                continue;

            actor.GetPose(frame, pose);
            ForwardKinematics.ToWorld(pose, pose);
            Vector3 feet = (pose[(int)Bone.LeftFoot].Position + pose[(int)Bone.RightFoot].Position) / 2;
            Vector3 centre = CenterOfMass.Compute(pose, SkeletonBody.GetDefault());
            Assert.True(new Vector2(centre.X - feet.X, centre.Z - feet.Z).Length() < 20, $"{frame}: {centre} over {feet}");
            tested++;
        }

        Assert.True(tested > 100, $"{tested} frames");
    }

    [Fact]
    public void Too_few_transforms_are_refused_and_nothing_is_allocated()
    {
        BoneTransform[] pose = Rest(SkeletonVariant.Neck1);
        Allocations.AssertNone(() => CenterOfMass.Compute(pose, SkeletonBody.GetDefault()));
        Assert.Throws<ArgumentException>(() => CenterOfMass.Compute(pose.AsSpan(1), SkeletonBody.GetDefault()));
    }

    private static BoneTransform[] Rest(SkeletonVariant variant)
    {
        BoneTransform[] pose = new BoneTransform[59];
        SkeletonBody.GetDefault(variant).CopyRestPose(pose);
        return pose;
    }

    private static Vector3 Compute(BoneTransform[] local, SkeletonVariant variant)
    {
        BoneTransform[] world = new BoneTransform[59];
        ForwardKinematics.ToWorld(local, world, variant);
        return CenterOfMass.Compute(world, SkeletonBody.GetDefault(variant));
    }
}
