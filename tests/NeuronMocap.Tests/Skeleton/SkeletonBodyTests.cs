using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public sealed class SkeletonBodyTests
{
    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void The_default_body_has_the_default_offsets_and_stands_on_the_ground(SkeletonVariant variant)
    {
        var body = SkeletonBody.GetDefault(variant);
        Assert.Same(body, SkeletonBody.GetDefault(variant));
        Assert.Equal(variant, body.Variant);
        Assert.Equal(0, GroundOf(body), 1e-4f);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            DefaultOffsets.TryGetEndSite(bone, out Vector3 end);
            Assert.Equal(DefaultOffsets.Get(bone, variant), body.GetOffset(bone));
            Assert.Equal(end, body.EndSites[(int)bone]);
        }
    }

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void A_body_of_given_sizes_measures_them(SkeletonVariant variant)
    {
        var random = new Random(3);
        for (int i = 0; i < 100; i++)
        {
            BoneDimensions sizes = RandomSizes(random);
            var body = SkeletonBody.FromDimensions(sizes, variant);
            AssertEqual(sizes, body.Measure());
            Assert.Equal(variant, body.Variant);
            Assert.Equal(0, GroundOf(body), 1e-3f);
            Assert.Equal((sizes.UpperLeg + sizes.LowerLeg + sizes.HeelHeight) * 100, body.GetOffset(Bone.Hips).Y, 1e-3f);
        }
    }

    [Fact]
    public void The_sizes_of_the_default_body_make_the_default_body()
    {
        var made = SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure());
        foreach (Bone bone in BoneHierarchy.Bones)
            Assert.True(Vector3.Distance(DefaultOffsets.Get(bone), made.GetOffset(bone)) < 1e-3f, $"{bone}: {made.GetOffset(bone)}");
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void Impossible_sizes_are_refused(float size) =>
        Assert.Throws<ArgumentException>(() => SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure() with { Palm = size }));

    [Fact]
    public void A_pose_of_a_body_makes_that_body()
    {
        var actor = SkeletonBody.FromDimensions(RandomSizes(new Random(4)));
        BoneTransform[] pose = new BoneTransform[59];
        actor.CopyRestPose(pose);
        for (int bone = 0; bone < 59; bone++)
            pose[bone] = pose[bone] with { Rotation = EulerAngles.ToQuaternion(new Vector3(bone, 2 * bone, 3), RotationOrder.YXZ) };
        pose[0] = pose[0] with { Position = new Vector3(200, 30, -100) };

        var found = SkeletonBody.FromPose(pose, SkeletonVariant.Neck1, actor.EndSites);

        Assert.Equal(actor.Offsets[1..].ToArray(), found.Offsets[1..].ToArray());
        Assert.Equal(actor.EndSites.ToArray(), found.EndSites.ToArray());
        Assert.True(Vector3.Distance(actor.Offsets[0], found.Offsets[0]) < 1e-3f);
    }

    [Fact]
    public void A_body_copies_its_input()
    {
        Vector3[] offsets = SkeletonBody.GetDefault().Offsets.ToArray();
        Vector3[] ends = SkeletonBody.GetDefault().EndSites.ToArray();
        ends[(int)Bone.Hips] = Vector3.One; // has children, so the value is ignored
        var body = new SkeletonBody(offsets, ends, SkeletonVariant.Spine3);
        Array.Clear(offsets);
        Array.Clear(ends);

        Assert.Equal(SkeletonBody.GetDefault().Offsets.ToArray(), body.Offsets.ToArray());
        Assert.Equal(SkeletonBody.GetDefault().EndSites.ToArray(), body.EndSites.ToArray());
        Assert.Equal(SkeletonVariant.Spine3, body.Variant);
    }

    [Fact]
    public void Fewer_than_59_are_refused()
    {
        Assert.Equal("offsets", Assert.Throws<ArgumentException>(() => new SkeletonBody(new Vector3[58])).ParamName);
        Assert.Equal("endSites", Assert.Throws<ArgumentException>(() => new SkeletonBody(new Vector3[59], new Vector3[58])).ParamName);
        Assert.Equal("pose", Assert.Throws<ArgumentException>(() => SkeletonBody.FromPose(new BoneTransform[58])).ParamName);
        Assert.Equal("pose", Assert.Throws<ArgumentException>(() => SkeletonBody.GetDefault().CopyRestPose(new BoneTransform[58])).ParamName);
    }

    private static BoneDimensions RandomSizes(Random random)
    {
        float Around(float size) => size * (0.6f + (random.NextSingle() * 0.8f));
        return new BoneDimensions
        {
            Head = Around(0.17f),
            Neck = Around(0.09f),
            Body = Around(0.5f),
            ShoulderWidth = Around(0.3f),
            UpperArm = Around(0.25f),
            Forearm = Around(0.25f),
            Palm = Around(0.08f),
            HipWidth = Around(0.2f),
            UpperLeg = Around(0.4f),
            LowerLeg = Around(0.4f),
            HeelHeight = Around(0.1f),
            FootLength = Around(0.16f),
        };
    }

    private static void AssertEqual(BoneDimensions expected, BoneDimensions actual)
    {
        byte[] expectedBytes = new byte[BoneDimensions.Size];
        byte[] actualBytes = new byte[BoneDimensions.Size];
        expected.Write(expectedBytes);
        actual.Write(actualBytes);
        for (int i = 0; i < expectedBytes.Length; i += 4)
            Assert.Equal(BitConverter.ToSingle(expectedBytes, i), BitConverter.ToSingle(actualBytes, i), 1e-6f);
    }

    private static float GroundOf(SkeletonBody body)
    {
        BoneTransform[] pose = new BoneTransform[59];
        body.CopyRestPose(pose);
        ForwardKinematics.ToWorld(pose, pose, body.Variant);
        return JointPositions.GetLowest(pose, body).Y;
    }
}
