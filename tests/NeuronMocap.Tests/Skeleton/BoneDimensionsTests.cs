using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public class BoneDimensionsTests
{
    [Theory]
    [InlineData(SkeletonVariant.Neck1, 0.09f, 0.51f)]
    [InlineData(SkeletonVariant.Spine3, 0.0892f, 0.5108f)]
    public void The_default_body_has_the_sizes_of_appendix_b(SkeletonVariant variant, float neck, float body)
    {
        var actual = BoneDimensions.Measure(DefaultPose(variant), variant);

        AssertEqual(Sizes(new BoneDimensions
        {
            Head = 0.17f,
            Neck = neck,
            Body = body,
            ShoulderWidth = 0.28f,
            UpperArm = 0.25f,
            Forearm = 0.25f,
            Palm = MathF.Sqrt((8.311f * 8.311f) + (0.42f * 0.42f) + (1.04f * 1.04f)) / 100,
            HipWidth = 0.19f,
            UpperLeg = 0.37051f,
            LowerLeg = 0.37051f,
            HeelHeight = 0.1f,
            FootLength = 0.1575f,
        }), Sizes(actual));
    }

    [Fact]
    public void Rotations_and_the_place_of_the_hips_do_not_matter()
    {
        BoneTransform[] pose = DefaultPose(SkeletonVariant.Neck1);
        var still = BoneDimensions.Measure(pose);
        for (int bone = 0; bone < pose.Length; bone++)
            pose[bone] = pose[bone] with { Rotation = Quaternion.CreateFromYawPitchRoll(bone, bone * 2, bone * 3) };
        pose[0] = pose[0] with { Position = new Vector3(500, 0, -1) };

        Assert.Equal(still, BoneDimensions.Measure(pose));
    }

    [Fact]
    public void Sides_are_averaged_and_end_sites_of_the_body_are_used()
    {
        BoneTransform[] pose = DefaultPose(SkeletonVariant.Neck1);
        pose[(int)Bone.LeftForeArm] = new BoneTransform(new Vector3(35, 0, 0), Quaternion.Identity);
        Vector3[] ends = new Vector3[59];
        ends[(int)Bone.Head] = new Vector3(0, 20, 0);
        ends[(int)Bone.RightFoot] = new Vector3(3, -8, 4);
        ends[(int)Bone.LeftFoot] = new Vector3(0, -6, 15);
        var actual = BoneDimensions.Measure(pose, SkeletonVariant.Neck1, ends);

        Assert.Equal(0.3f, actual.UpperArm, 1e-6);
        Assert.Equal(0.2f, actual.Head, 1e-6);
        Assert.Equal(0.07f, actual.HeelHeight, 1e-6);
        Assert.Equal(0.1f, actual.FootLength, 1e-6);
    }

    [Fact]
    public void The_wire_has_twelve_floats_in_the_order_of_the_manual()
    {
        byte[] bytes = new byte[50];
        for (int i = 0; i < 12; i++)
            BitConverter.GetBytes(i + 0.5f).CopyTo(bytes, i * 4);
        bytes[48] = 7;

        Assert.True(BoneDimensions.TryRead(bytes, out BoneDimensions read));
        AssertEqual([.. Enumerable.Range(0, 12).Select(i => i + 0.5f)], Sizes(read));
        byte[] written = new byte[BoneDimensions.Size];
        read.Write(written);
        Assert.Equal(bytes[..48], written);
    }

    [Theory]
    [InlineData(-0.001f)]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    [InlineData(float.NegativeInfinity)]
    public void Impossible_sizes_are_not_read(float wrong)
    {
        for (int i = 0; i < 12; i++)
        {
            byte[] bytes = new byte[48];
            BitConverter.GetBytes(wrong).CopyTo(bytes, i * 4);
            Assert.False(BoneDimensions.TryRead(bytes, out _));
        }
    }

    [Fact]
    public void Too_little_is_refused()
    {
        Assert.False(BoneDimensions.TryRead(new byte[47], out _));
        Assert.Throws<ArgumentException>(() => default(BoneDimensions).Write(new byte[47]));
        Assert.Throws<ArgumentException>(() => BoneDimensions.Measure(new BoneTransform[58]));
        Assert.Throws<ArgumentException>(() => BoneDimensions.Measure(new BoneTransform[59], SkeletonVariant.Neck1, new Vector3[58]));
    }

    private static BoneTransform[] DefaultPose(SkeletonVariant variant) =>
        [.. BoneHierarchy.Bones.ToArray().Select(bone => new BoneTransform(DefaultOffsets.Get(bone, variant), Quaternion.Identity))];

    private static float[] Sizes(BoneDimensions sizes) =>
    [
        sizes.Head, sizes.Neck, sizes.Body, sizes.ShoulderWidth, sizes.UpperArm, sizes.Forearm,
        sizes.Palm, sizes.HipWidth, sizes.UpperLeg, sizes.LowerLeg, sizes.HeelHeight, sizes.FootLength,
    ];

    private static void AssertEqual(float[] expected, float[] actual)
    {
        Assert.Equal(expected.Length, actual.Length);
        for (int i = 0; i < expected.Length; i++)
            Assert.Equal(expected[i], actual[i], 1e-6);
    }
}
