using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhSkeletonMapTests
{
    [Theory]
    [InlineData(SkeletonVariant.Neck1, false)]
    [InlineData(SkeletonVariant.Neck1, true)]
    [InlineData(SkeletonVariant.Spine3, false)]
    [InlineData(SkeletonVariant.Spine3, true)]
    public void Both_variants_are_found_with_and_without_displacement(SkeletonVariant variant, bool displacement)
    {
        BvhSkeletonMap map = Create(Neuron(variant, displacement));

        Assert.Equal(new SkeletonFormat(RotationOrder.YXZ, variant), map.Format);
        Assert.Equal(new ChannelLayout(displacement, hasReference: false), map.Layout);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Assert.Equal(BoneHierarchy.GetName(bone, variant), map[bone].Name);
            Assert.Equal((int)bone, map[bone].Index);
        }
    }

    [Theory]
    [InlineData("Xrotation Zrotation Yrotation", RotationOrder.XZY)]
    [InlineData("Yrotation Xrotation Zrotation", RotationOrder.YXZ)]
    [InlineData("Xrotation Yrotation Zrotation", RotationOrder.XYZ)]
    [InlineData("Yrotation Zrotation Xrotation", RotationOrder.YZX)]
    [InlineData("Zrotation Xrotation Yrotation", RotationOrder.ZXY)]
    [InlineData("Zrotation Yrotation Xrotation", RotationOrder.ZYX)]
    public void The_rotation_order_follows_the_channels(string rotations, RotationOrder order) =>
        Assert.Equal(order, Create(Neuron(rotations: rotations)).Format.RotationOrder);

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Values_in_stream_order_are_copied(bool displacement)
    {
        BvhSkeletonMap map = Create(Neuron(displacement: displacement));
        float[] values = new float[map.Layout.ValueCount + 1];
        values[^1] = -1;
        map.CopyValues(0, values);

        AssertBits([.. map.Document.GetValues(0), -1], values);
    }

    [Fact]
    public void Reordered_channels_are_mapped_to_the_stream()
    {
        string text = Neuron(displacement: true).Replace(
            "Xposition Yposition Zposition Yrotation Xrotation Zrotation",
            "Yrotation Zposition Xrotation Xposition Zrotation Yposition",
            StringComparison.Ordinal);
        BvhSkeletonMap map = Create(text);
        float[] values = new float[354];
        map.CopyValues(0, values);

        Assert.Equal(RotationOrder.YXZ, map.Format.RotationOrder);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            int first = 6 * (int)bone;
            AssertBits([first + 3, first + 5, first + 1, first, first + 2, first + 4], values.AsSpan(first, 6));
        }
    }

    [Fact]
    public void Joint_order_and_extra_joints_do_not_matter()
    {
        string text = Neuron(edit: (bone, joint) => bone switch
        {
            Bone.RightUpLeg => "JOINT Tail\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\nEnd Site\n{\nOFFSET 0 0 1\n}\n}\n" + joint,
            _ => joint,
        });
        text = MoveLeftLegToTheFront(text).Replace("179\n", "179 180 181 182\n", StringComparison.Ordinal);
        BvhSkeletonMap map = Create(text);
        float[] values = new float[180];
        map.CopyValues(0, values);

        Assert.StartsWith("Hips LeftUpLeg LeftLeg LeftFoot Tail RightUpLeg ", NamesOf(map.Document), StringComparison.Ordinal);
        Assert.Equal(183, map.Document.ChannelCount);
        AssertBits([0, 1, 2, 3, 4, 5], values.AsSpan(0, 6));
        AssertBits([18, 19, 20], values.AsSpan(map.Layout.GetRotationIndex(Bone.RightUpLeg), 3));
        AssertBits([6, 7, 8], values.AsSpan(map.Layout.GetRotationIndex(Bone.LeftUpLeg), 3));
    }

    [Fact]
    public void Transforms_fall_back_to_offsets_without_positions()
    {
        BoneTransform[] still = new BoneTransform[59];
        BvhSkeletonMap without = Create(Neuron());
        without.CopyLocalTransforms(0, still);
        BoneTransform[] moved = new BoneTransform[59];
        Create(Neuron(displacement: true)).CopyLocalTransforms(0, moved);

        Assert.Equal(new Vector3(0, 1, 2), still[0].Position);
        Assert.Equal(new Vector3(58, 0.5f, -1), still[58].Position);
        Assert.Equal(new Vector3(348, 349, 350), moved[58].Position);
        Assert.Equal(EulerAngles.ToQuaternion(new Vector3(177, 178, 179), RotationOrder.YXZ), still[58].Rotation);
        Assert.Equal(EulerAngles.ToQuaternion(new Vector3(351, 352, 353), RotationOrder.YXZ), moved[58].Rotation);
    }

    [Fact]
    public void A_skeleton_of_fewer_joints_is_not_neurons() =>
        Assert.Equal("The file has no joint named RightUpLeg; its first joint is named Hips.", Refuse(TwoRows));

    [Theory]
    [InlineData(Bone.LeftHandPinky3, "LeftHandPinky3", "LeftPinkyEnd", "no joint named LeftHandPinky3")]
    [InlineData(Bone.Neck1, "Neck1", "Neck2", "no joint named Neck1")]
    [InlineData(Bone.Spine2, "Spine2", "Spine3", "no joint named Spine2")]
    [InlineData(Bone.LeftLeg, "LeftLeg", "LeftFoot", "two joints named LeftFoot")]
    [InlineData(Bone.LeftLeg, "Xrotation Zrotation", "Zrotation Xrotation", "rotation order of joint LeftLeg is YZX, but that of the hips is YXZ")]
    [InlineData(Bone.LeftLeg, "Zrotation", "Xrotation", "Joint LeftLeg does not have one rotation channel for each")]
    [InlineData(Bone.LeftLeg, "3 Yrotation", "2", "Joint LeftLeg does not have one rotation channel for each")]
    [InlineData(Bone.LeftLeg, "3 Y", "6 Xposition Yposition Zposition Y", "Joint LeftLeg has 3 position channels")]
    [InlineData(Bone.Spine, "3 Y", "6 Xposition Yposition Zposition Y", "Joint RightUpLeg has 0 position channels")]
    [InlineData(Bone.Hips, "6 Xposition", "5", "Joint Hips has 2 position channels")]
    [InlineData(Bone.Hips, "Xposition", "Zposition", "Joint Hips has the same position channel twice")]
    public void The_reason_names_the_joint_that_differs(Bone changed, string original, string replacement, string told)
    {
        string text = Neuron(edit: (bone, joint) => bone == changed ? joint.Replace(original, replacement, StringComparison.Ordinal) : joint);
        Assert.Contains(told, Refuse(text), StringComparison.Ordinal);
    }

    [Fact]
    public void Shoulders_must_have_the_variants_parent()
    {
        string text = Neuron(SkeletonVariant.Spine3)
            .Replace("JOINT Neck\n", "JOINT Neck1\n", StringComparison.Ordinal)
            .Replace("JOINT Spine3\n", "JOINT Neck\n", StringComparison.Ordinal);
        Assert.Equal("The parent of joint RightShoulder must be Spine2, not Neck.", Refuse(text));
    }

    [Fact]
    public void Hips_below_another_joint_are_not_neurons() => Assert.Equal(
        "The parent of joint Hips must be nothing, not Stage.",
        Refuse(UnderRoot("Stage", "6 Xposition Yposition Zposition Yrotation Xrotation Zrotation")));

    [Fact]
    public void Hips_may_be_below_a_reference_node()
    {
        BvhSkeletonMap map = Create(UnderRoot("Reference", "6 Xposition Yposition Zposition Yrotation Xrotation Zrotation"));
        float[] values = new float[186];
        map.CopyValues(0, values);
        BoneTransform[] pose = new BoneTransform[59];
        map.CopyLocalTransforms(0, pose);

        Assert.Equal(new ChannelLayout(hasDisplacement: false, hasReference: true), map.Layout);
        AssertBits(map.Document.GetValues(0), values);
        Assert.Equal(
            new BoneTransform(new Vector3(-6, -5, -4), EulerAngles.ToQuaternion(new Vector3(-3, -2, -1), RotationOrder.YXZ)),
            map.GetReference(0));
        Assert.Equal(new Vector3(0, 1, 2), pose[0].Position);
    }

    [Fact]
    public void A_file_without_a_reference_node_is_relative_to_the_world() =>
        Assert.Equal(BoneTransform.Identity, Create(Neuron()).GetReference(0));

    [Theory]
    [InlineData("3 Yrotation Xrotation Zrotation", "Joint Reference has 0 position channels")]
    [InlineData("6 Xposition Yposition Zposition Xrotation Yrotation Zrotation", "rotation order of joint Reference is XYZ, but that of the hips is YXZ")]
    public void A_reference_node_of_other_channels_is_not_neurons(string channels, string told) =>
        Assert.Contains(told, Refuse(UnderRoot("Reference", channels)), StringComparison.Ordinal);

    [Fact]
    public void Rows_of_a_reader_give_poses()
    {
        string text = UnderRoot("Reference", "6 Xposition Yposition Zposition Yrotation Xrotation Zrotation");
        BvhSkeletonMap whole = Create(text);
        using var reader = new BvhReader(new MemoryStream(System.Text.Encoding.UTF8.GetBytes(text)));
        Assert.True(BvhSkeletonMap.TryCreate(reader.Hierarchy, out BvhSkeletonMap? map, out string? reason), reason);
        float[] row = new float[reader.Hierarchy.ChannelCount];
        Assert.True(reader.TryReadFrame(row));

        var expected = new BoneTransform[BoneHierarchy.BoneCount];
        var actual = new BoneTransform[BoneHierarchy.BoneCount];
        whole.CopyLocalTransforms(0, expected);
        map.CopyLocalTransforms(row, actual);

        Assert.Equal(expected, actual);
        Assert.Equal(whole.GetReference(0), map.GetReference(row));
        Assert.NotEqual(BoneTransform.Identity, map.GetReference(row));
        Assert.Equal((whole.Layout, whole.Format, 0), (map.Layout, map.Format, map.Document.FrameCount));
        Assert.Throws<ArgumentOutOfRangeException>(() => map.CopyLocalTransforms(0, actual));
    }

    [Fact]
    public void Wrong_arguments_are_refused()
    {
        BvhSkeletonMap map = Create(Neuron());

        Assert.Throws<ArgumentNullException>(() => BvhSkeletonMap.TryCreate((BvhDocument)null!, out _, out _));
        Assert.Throws<ArgumentOutOfRangeException>(() => map[(Bone)59]);
        Assert.Throws<ArgumentException>(() => map.CopyValues(0, new float[179]));
        Assert.Throws<ArgumentOutOfRangeException>(() => map.CopyValues(1, new float[180]));
        Assert.Throws<ArgumentException>(() => map.CopyLocalTransforms(0, new BoneTransform[58]));
        Assert.Throws<ArgumentOutOfRangeException>(() => map.CopyLocalTransforms(-1, new BoneTransform[59]));
        Assert.Throws<ArgumentNullException>(() => BvhSkeletonMap.TryCreate((BvhHierarchy)null!, out _, out _));
        Assert.Throws<ArgumentException>(() => map.CopyValues(new float[179], new float[180]));
        Assert.Throws<ArgumentException>(() => map.CopyLocalTransforms(new float[179], new BoneTransform[59]));
        Assert.Throws<ArgumentException>(() => map.GetReference(new float[179]));
    }

    private static BvhSkeletonMap Create(string text)
    {
        Assert.True(BvhSkeletonMap.TryCreate(Parse(text), out BvhSkeletonMap? map, out string? reason), reason);
        return map;
    }

    private static string Refuse(string text)
    {
        Assert.False(BvhSkeletonMap.TryCreate(Parse(text), out BvhSkeletonMap? map, out string? reason));
        Assert.Null(map);
        return reason;
    }

    private static string MoveLeftLegToTheFront(string text)
    {
        int right = text.IndexOf("JOINT Tail", StringComparison.Ordinal);
        int left = text.IndexOf("JOINT LeftUpLeg", StringComparison.Ordinal);
        int end = text.IndexOf("JOINT Spine", StringComparison.Ordinal);
        return text[..right] + text[left..end] + text[right..left] + text[end..];
    }
}
