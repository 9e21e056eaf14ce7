using System.Diagnostics;
using NeuronMocap.Server.Osc;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Tests.Osc;

public sealed class OscPoseEncoderTests
{
    private readonly AvatarPoses _poses = new(new AvatarChoice(null, null, onlyOne: false));

    [Theory]
    [InlineData(OscSpace.World, SkeletonVariant.Neck1)]
    [InlineData(OscSpace.Local, SkeletonVariant.Spine3)]
    public void Each_bone_is_a_message_with_its_transform(OscSpace space, SkeletonVariant variant)
    {
        MotionFrame frame = Poses.Frame(3, variant: variant);
        AvatarPose pose = Take(frame);
        var encoder = new OscPoseEncoder(_poses, "/neuron", space, scale: 1, pose.Timestamp - Stopwatch.Frequency);
        List<byte[]> datagrams = Poses.Encode(encoder, pose);
        Assert.All(datagrams, static datagram => Assert.InRange(datagram.Length, 1, 1400));
        OscMessage[] messages = Poses.Decode(datagrams);
        Assert.Equal(BoneHierarchy.BoneCount + 1, messages.Length);

        BoneTransform[] expected = Poses.World(frame);
        if (space == OscSpace.Local)
        {
            BoneTransform hips = expected[0];
            ForwardKinematics.ToLocal(expected, expected, variant);
            expected[0] = hips;
        }

        for (int bone = 0; bone < expected.Length; bone++)
        {
            Assert.Equal($"/neuron/Ann/{BoneHierarchy.GetName((Bone)bone, variant)}", messages[bone].Address);
            Assert.Equal("fffffff", messages[bone].Types);
            Poses.AssertSame(expected[bone], Poses.TransformOf(messages[bone]), tolerance: 0.01f, messages[bone].Address);
        }

        Assert.Equal("/neuron/Ann/frame", messages[^1].Address);
        Assert.Equal([3, 1f], messages[^1].Arguments);
    }

    [Fact]
    public void A_scale_of_a_hundredth_gives_metres()
    {
        MotionFrame frame = Poses.Frame();
        OscMessage[] messages = Poses.Decode(Poses.Encode(new OscPoseEncoder(_poses, "/a", OscSpace.World, 0.01f, 0), Take(frame)));
        BoneTransform head = Poses.World(frame)[(int)Bone.Head];
        Poses.AssertSame(head with { Position = head.Position / 100 }, Poses.TransformOf(messages[(int)Bone.Head]), 1e-4f, messages[(int)Bone.Head].Address);
    }

    [Fact]
    public void Names_become_parts_of_addresses_that_differ()
    {
        string[] names = ["Ann", "Ann", "a b/c*#?[]{},", "演员", "演出", "", new string('n', 32)];
        string[] expected = ["Ann", "Ann-1", "a_b_c________", "__", "__-4", "avatar5", new string('n', 32)];
        var encoder = new OscPoseEncoder(_poses, "/neuron", OscSpace.Local, 1, 0);
        for (int avatar = 0; avatar < names.Length; avatar++)
            Assert.Equal($"/neuron/{expected[avatar]}/Hips", HipsAddress(encoder, Poses.Frame(1, avatar, names[avatar])));

        // A new name has a new address, and frees the old one.
        Assert.Equal("/neuron/Bob/Hips", HipsAddress(encoder, Poses.Frame(1, 0, "Bob")));
        Assert.Equal("/neuron/Ann/Hips", HipsAddress(encoder, Poses.Frame(1, 7, "Ann")));
        Assert.Equal("/neuron/Ann-1/Hips", HipsAddress(encoder, Poses.Frame(1, 1, "Ann")));
    }

    [Fact]
    public void A_value_that_is_not_finite_sends_nothing()
    {
        float[] values = new float[354];
        values[6] = float.NaN;
        AvatarPose pose = Take(new MotionFrame(new MotionHeader { HasDisplacement = true }, values));
        var encoder = new OscPoseEncoder(_poses, "/neuron", OscSpace.Local, 1, 0);
        Assert.False(encoder.TryEncode(pose, new OscBundle(1400, static (_, _) => Assert.Fail("Something was sent."))));
    }

    [Theory]
    [InlineData(OscSpace.World)]
    [InlineData(OscSpace.Local)]
    public void Rotations_are_unit_quaternions(OscSpace space)
    {
        AvatarPose pose = Take(Poses.Frame());
        for (int bone = 0; bone < pose.Local.Length; bone++)
            pose.Local[bone] = pose.Local[bone] with { Rotation = pose.Local[bone].Rotation * 1.01f };

        OscMessage[] messages = Poses.Decode(Poses.Encode(new OscPoseEncoder(_poses, "/neuron", space, 1, 0), pose));
        Assert.All(messages[..^1], static message => Assert.InRange(Poses.TransformOf(message).Rotation.Length(), 0.99999f, 1.00001f));
    }

    // Each value is finite, but not its product with the scale, or the sum of two.
    [Theory]
    [InlineData(OscSpace.Local, 1e37f, 100)]
    [InlineData(OscSpace.World, 3e38f, 1)]
    public void No_infinity_is_sent(OscSpace space, float position, float scale)
    {
        float[] values = new float[354];
        values[0] = values[6] = position;
        AvatarPose pose = Take(new MotionFrame(new MotionHeader { HasDisplacement = true }, values));
        var encoder = new OscPoseEncoder(_poses, "/neuron", space, scale, 0);
        Assert.False(encoder.TryEncode(pose, new OscBundle(1400, static (_, _) => Assert.Fail("Something was sent."))));
    }

    [Fact]
    public void Nothing_is_allocated()
    {
        var encoder = new OscPoseEncoder(_poses, "/neuron", OscSpace.World, 1, 0);
        var bundle = new OscBundle(1400, static (_, _) => { });
        MotionFrame frame = Poses.Frame();
        Allocations.AssertNone(() =>
        {
            _poses.Take(frame);
            encoder.TryEncode(_poses.All[0], bundle);
        });
    }

    private string HipsAddress(OscPoseEncoder encoder, MotionFrame frame) => Poses.Decode(Poses.Encode(encoder, Take(frame)))[0].Address;

    private AvatarPose Take(MotionFrame frame)
    {
        _poses.Take(frame);
        return _poses.All.Single(pose => pose.Index == frame.AvatarIndex);
    }
}
