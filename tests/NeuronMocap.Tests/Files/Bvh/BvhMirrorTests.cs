using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhMirrorTests
{
    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void Every_joint_mirrors_its_partner(SkeletonVariant variant)
    {
        BvhHierarchy hierarchy = BvhBoneHierarchy.Create(new SkeletonFormat(RotationOrder.ZXY, variant), new ChannelLayout(hasDisplacement: true, hasReference: true));
        BvhDocument take = new RandomTakes(5).Take(hierarchy, 3);

        AssertMirrored(take, take.Mirror(), OtherSide);
    }

    // Sides with different channels, orders and offsets, and joints that are their own partner.
    [Theory]
    [InlineData("lArm", "rArm")]
    [InlineData("LHip", "RHip")]
    [InlineData("Arm.L", "Arm.R")]
    [InlineData("Arm_l_01", "Arm_r_01")]
    [InlineData("Bip01 L Thigh", "Bip01 R Thigh")]
    [InlineData("mixamorig:LeftArm", "mixamorig:RightArm")]
    [InlineData("upperarmL", "upperarmR")]
    [InlineData("left_arm", "right_arm")]
    public void Sides_are_found_by_name(string left, string right)
    {
        BvhDocument take = Parse(
            $$"""
            HIERARCHY
            ROOT lower
            {
            OFFSET 1 2 3
            CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
            JOINT {{right}}
            {
            OFFSET -2 0 1
            CHANNELS 3 Xrotation Yrotation Zrotation
            JOINT Thumb
            {
            OFFSET -1 0 0
            CHANNELS 2 Yrotation Xrotation
            End Site
            {
            OFFSET -1 1 0
            }
            }
            }
            JOINT Left-over
            {
            OFFSET 0.5 7 0
            CHANNELS 1 Zrotation
            }
            JOINT {{left}}
            {
            OFFSET 2.5 0 1
            CHANNELS 4 Yposition Zrotation Xrotation Zrotation
            JOINT Thumb2
            {
            OFFSET 1 0 0
            CHANNELS 0
            End Site
            {
            OFFSET 1 2 0
            }
            }
            }
            }
            MOTION
            Frames: 1
            Frame Time: 0.01
            1 2 3 10 20 30 11 12 13 14 15 16 5 41 42 43

            """.Replace("Thumb2", "Thumb", StringComparison.Ordinal));

        BvhDocument mirrored = take.Mirror();
        Assert.Equal(["lower", right, "Thumb", "Left-over", left, "Thumb"], mirrored.Joints.Select(static joint => joint.Name));
        AssertBits([-1, 2, 3, -10, 20, -30, 5, -41, 42, -43, -16, 11, -12, -13, -14, 15], Values(mirrored));
        Assert.Equal(-2.5f, mirrored.Joints[1].Offset.X);
        Assert.Equal(new(-1, 2, 0), mirrored.Joints[2].EndSite);
        Assert.Equal(-0.5f, mirrored.Joints[3].Offset.X);
        AssertBits(Values(take), Values(mirrored.Mirror()));
    }

    [Fact]
    public void Unmatched_sides_are_refused()
    {
        BvhDocument take = Parse(
            "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 0\nJOINT LeftArm\n{\nOFFSET 0 0 0\nCHANNELS 0\nJOINT LeftHand\n{\nOFFSET 0 0 0\nCHANNELS 0\n}\n}\n"
            + "JOINT RightArm\n{\nOFFSET 0 0 0\nCHANNELS 0\n}\n}\n");
        NeuronException failure = Assert.Throws<NeuronException>(take.Mirror);
        Assert.Contains("LeftHand is a child of LeftArm, but RightArm has no matching child", failure.Message, StringComparison.Ordinal);
    }

    internal static string OtherSide(string name) => name switch
    {
        _ when name.StartsWith("Left", StringComparison.Ordinal) => "Right" + name[4..],
        _ when name.StartsWith("Right", StringComparison.Ordinal) => "Left" + name[5..],
        _ => name,
    };

    internal static void AssertMirrored(BvhDocument take, BvhDocument mirrored, Func<string, string> otherSide)
    {
        for (int frame = 0; frame < take.FrameCount; frame++)
        {
            var pose = new RawPose(take, frame);
            var mirror = new RawPose(mirrored, frame);
            foreach (string name in pose.Names)
            {
                double[] expected = pose.Position(otherSide(name));
                double[] actual = mirror.Position(name);
                Assert.Equal(-expected[0], actual[0], 1e-4);
                Assert.Equal(expected[1], actual[1], 1e-4);
                Assert.Equal(expected[2], actual[2], 1e-4);
            }
        }
    }
}
