using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Server.Tests.Sources;

public sealed class BvhSourceTests
{
    [Fact]
    public void A_file_of_another_skeleton_is_refused_with_the_missing_joint()
    {
        BvhDocument document = BvhDocument.Parse(Encoding.ASCII.GetBytes(
            "HIERARCHY\nROOT Pelvis\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n"
            + "MOTION\nFrames: 1\nFrame Time: 0.01\n1 2 3\n"));
        Assert.Contains("Hips", Assert.Throws<NeuronException>(() => new BvhSource(document)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_skeleton_without_frames_is_refused()
    {
        BvhDocument document = BvhDocument.Parse(NeuronTake.Write(rows: 0));
        Assert.Contains("no frames", Assert.Throws<NeuronException>(() => new BvhSource(document)).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(RotationOrder.XYZ)]
    [InlineData(RotationOrder.ZXY)]
    public void Another_rotation_order_gives_the_same_pose(RotationOrder order)
    {
        var source = new BvhSource(BvhDocument.Parse(NeuronTake.Write(rows: 3)));
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: false);
        float[] values = new float[layout.ValueCount];
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        source.WriteValues(2, layout, order, values);
        source.GetPose(2, pose);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            ReadOnlySpan<float> angles = values.AsSpan(layout.GetRotationIndex(bone), 3);
            Quaternion rotation = EulerAngles.ToQuaternion(new Vector3(angles[0], angles[1], angles[2]), order);
            Assert.Equal(1, Math.Abs(Quaternion.Dot(rotation, pose[(int)bone].Rotation)), tolerance: 1e-5);
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Hips_below_a_reference_node_are_in_world_space(bool reference)
    {
        var file = new ChannelLayout(hasDisplacement: false, hasReference: true);
        float[] row = [.. Enumerable.Range(0, file.ValueCount).Select(static i => i * 13 % 50 - 20f)];
        string text = BvhHierarchyText.Create(SkeletonFormat.Default, file) + "MOTION\nFrames: 1\nFrame Time: 0.01\n" + string.Join(' ', row.Select(static value => value.ToString(CultureInfo.InvariantCulture))) + "\n";
        var source = new BvhSource(BvhDocument.Parse(Encoding.ASCII.GetBytes(text)));

        var layout = new ChannelLayout(hasDisplacement: false, reference);
        float[] values = new float[layout.ValueCount];
        source.WriteValues(0, layout, RotationOrder.YXZ, values);
        if (reference)
            Assert.Equal(row, values);

        var frame = new MotionFrame(new MotionHeader { HasReference = reference }, values);
        BoneTransform[] expected = new BoneTransform[BoneHierarchy.BoneCount];
        source.GetPose(0, expected);
        BoneTransform hips = frame.GetReference().Apply(frame[Bone.Hips]);
        Assert.True(Vector3.Distance(expected[0].Position, hips.Position) < 1e-3);
        Assert.Equal(1, Math.Abs(Quaternion.Dot(expected[0].Rotation, hips.Rotation)), tolerance: 1e-5);
    }

    [Fact]
    public void Only_a_standing_foot_has_contact()
    {
        // The actor lifts the left leg in the second half of the take: the knee rises, and the foot with it.
        byte[] file = NeuronTake.Write(
            rows: 40, (row, bone) => row >= 20 && bone == Bone.LeftUpLeg ? new Vector3(0, -60, 0) : Vector3.Zero);
        var source = new BvhSource(BvhDocument.Parse(file));
        Assert.Equal(new FootContacts(true, true), source.GetFootContacts(5));
        Assert.Equal(new FootContacts(false, true), source.GetFootContacts(35));
        Assert.Equal(40, source.FrameCount);
    }
}
