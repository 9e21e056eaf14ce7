using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Data.Tests.Takes;

// A take recorded with a suit. It is not part of the repository.
public class BvhTakeTests
{
    [Fact]
    public void A_recorded_take_is_read_without_repairs()
    {
        BvhDocument document = BvhDocument.Load(Fixtures.Require("test-take", "test.bvh"));

        Assert.Equal(59, document.Joints.Count);
        Assert.Equal(180, document.ChannelCount);
        Assert.Equal(2156, document.FrameCount);
        Assert.Equal(0.008, document.DeclaredFrameTime);
        Assert.Equal(120, document.FrameRate);
        Assert.Equal(new Vector3(0, 93.02f, 0), document.Joints[0].Offset);
        Assert.Equal(new Vector3(0, -7.69f, 17.5f), document.Joints[3].EndSite);
        Assert.Equal(13, document.Joints.Count(joint => joint.EndSite is not null));
        Assert.Empty(document.Repairs);
    }

    [Fact]
    public void A_recorded_take_has_neurons_skeleton()
    {
        BvhDocument document = BvhDocument.Load(Fixtures.Require("test-take", "test.bvh"));

        Assert.True(BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason), reason);
        Assert.Equal(new SkeletonFormat(RotationOrder.YXZ, SkeletonVariant.Spine3), map.Format);
        Assert.Equal(180, map.Layout.ValueCount);
        float[] values = new float[180];
        map.CopyValues(2155, values);
        AssertBits(document.GetValues(2155), values);
    }

    [Fact]
    public void Every_number_of_a_recorded_take_is_read_as_the_nearest_float()
    {
        string text = File.ReadAllText(Fixtures.Require("test-take", "test.bvh"));
        BvhDocument document = BvhDocument.Parse(Encoding.UTF8.GetBytes(text));

        string[] words = text[text.IndexOf("Frame Time:", StringComparison.Ordinal)..].Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        float[] expected = [.. words.Skip(3).Select(word => float.Parse(word, CultureInfo.InvariantCulture))];
        Assert.Equal(2156 * 180, expected.Length);
        AssertBits(expected, Values(document));
    }

    [Theory]
    [InlineData("\n")]
    [InlineData("\r")]
    public void Line_ends_do_not_change_a_recorded_take(string lineEnd)
    {
        string text = File.ReadAllText(Fixtures.Require("test-take", "test.bvh"));
        Assert.Contains("\r\n", text, StringComparison.Ordinal);

        string converted = text.Replace("\r\n", lineEnd, StringComparison.Ordinal);
        AssertSame(Parse(text), Parse(converted));
    }

    // The actor stands on the ground, so offsets, channels and rotations fit together.
    [Fact]
    public void The_feet_of_a_recorded_take_reach_the_ground()
    {
        BvhDocument document = BvhDocument.Load(Fixtures.Require("test-take", "test.bvh"));
        Assert.True(BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out _));
        BoneTransform[] bones = new BoneTransform[BoneHierarchy.BoneCount];
        map.CopyLocalTransforms(0, bones);
        ForwardKinematics.ToWorld(bones, bones, map.Format.Variant);

        foreach (Bone foot in (Bone[])[Bone.RightFoot, Bone.LeftFoot])
        {
            Vector3 toes = bones[(int)foot].TransformPoint(map[foot].EndSite!.Value);
            Assert.Equal(0, toes.Y, 0.001f);
        }
    }
}
