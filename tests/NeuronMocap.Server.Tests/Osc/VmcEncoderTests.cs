using System.Diagnostics;
using System.Numerics;
using NeuronMocap.Server.Osc;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Tests.Osc;

public sealed class VmcEncoderTests
{
    [Theory]
    [InlineData(180, SkeletonVariant.Neck1)]
    [InlineData(186, SkeletonVariant.Spine3)]
    [InlineData(354, SkeletonVariant.Spine3)]
    [InlineData(360, SkeletonVariant.Neck1)]
    public void Every_bone_is_where_the_frame_has_it(int count, SkeletonVariant variant)
    {
        var encoder = new VmcEncoder(1, false, 0);
        for (int seed = 0; seed < 20; seed++)
        {
            // Positions of up to 180 cm for each bone add up to many metres.
            MotionFrame frame = Poses.Frame(seed, count: count, variant: variant);
            Show(encoder, frame).AssertShows(frame, tolerance: 2e-4f);
        }
    }

    [Fact]
    public void No_infinity_is_sent()
    {
        float[] values = new float[180];
        values[0] = 1e36f;
        AvatarPose pose = Poses.Taken(new MotionFrame(new MotionHeader(), values));
        Assert.False(new VmcEncoder(1e6f, false, 0).TryEncode(pose, new OscBundle(1400, static (_, _) => Assert.Fail("Something was sent."))));
    }

    [Fact]
    public void The_rest_pose_has_no_rotation()
    {
        var frame = new MotionFrame(new MotionHeader(), new float[180]);
        OscMessage[] messages = Poses.Decode(Poses.Encode(new VmcEncoder(1, false, 0), Poses.Taken(frame)));
        OscMessage[] bones = [.. messages.Where(static message => message.Address == "/VMC/Ext/Bone/Pos")];
        Assert.Equal(50, bones.Length);
        Assert.All(bones, static bone => Assert.Equal([0f, 0f, 0f, 1f], bone.Arguments[4..].Select(static value => Math.Abs((float)value))));
    }

    [Fact]
    public void The_frame_ends_with_ok_and_time_and_fits_into_small_datagrams()
    {
        AvatarPose pose = Poses.Taken(Poses.Frame());
        var encoder = new VmcEncoder(1, false, pose.Timestamp - (long)(2.5 * Stopwatch.Frequency));
        foreach (int size in (int[])[512, 1400, 65_507])
        {
            List<byte[]> datagrams = Poses.Encode(encoder, pose, size);
            Assert.All(datagrams, datagram => Assert.InRange(datagram.Length, 1, size));
            Assert.Equal(size switch { 512 => 10, 1400 => 4, _ => 1 }, datagrams.Count);
            OscMessage[] messages = Poses.Decode(datagrams);
            Assert.Equal("/VMC/Ext/Root/Pos", messages[0].Address);
            Assert.Equal(["root", 0f, 0f, 0f, 0f, 0f, 0f, 1f], messages[0].Arguments);
            Assert.Equal("Hips", messages[1].Arguments[0]);
            Assert.Equal(["/VMC/Ext/OK", "/VMC/Ext/T"], messages[^2..].Select(static message => message.Address));
            Assert.Equal(2.5f, messages[^1].Float(0));
        }
    }

    [Fact]
    public void A_scale_moves_a_smaller_model_less()
    {
        MotionFrame frame = Poses.Frame();
        Show(new VmcEncoder(0.5f, true, 0), frame).AssertShows(frame, tolerance: 2e-4f, scale: 0.5f);
    }

    [Fact]
    public void The_root_moves_over_the_ground_if_it_should()
    {
        MotionFrame frame = Poses.Frame();
        OscMessage[] messages = Poses.Decode(Poses.Encode(new VmcEncoder(1, true, 0), Poses.Taken(frame)));
        Vector3 hips = Poses.World(frame)[0].Position / 100;
        Assert.Equal(new Vector3(-hips.X, 0, hips.Z), Poses.TransformOf(messages[0]).Position);
        Assert.Equal(new Vector3(0, hips.Y, 0), Poses.TransformOf(messages[1]).Position);
        Show(new VmcEncoder(1, true, 0), frame).AssertShows(frame, tolerance: 2e-4f);
    }

    [Fact]
    public void A_value_that_is_not_finite_sends_nothing()
    {
        float[] values = new float[354];
        foreach (float bad in (float[])[float.NaN, float.PositiveInfinity])
        {
            values[100] = bad;
            AvatarPose pose = Poses.Taken(new MotionFrame(new MotionHeader { HasDisplacement = true }, values));
            Assert.False(new VmcEncoder(1, false, 0).TryEncode(pose, new OscBundle(1400, static (_, _) => Assert.Fail("Something was sent."))));
        }
    }

    [Fact]
    public void Nothing_is_allocated()
    {
        var encoder = new VmcEncoder(1, false, 0);
        var bundle = new OscBundle(1400, static (_, _) => { });
        MotionFrame frame = Poses.Frame();
        AvatarPose pose = Poses.Taken(frame);
        Allocations.AssertNone(() =>
        {
            pose.Take(frame);
            encoder.TryEncode(pose, bundle);
        });
    }

    private static VmcModel Show(VmcEncoder encoder, MotionFrame frame)
    {
        var model = new VmcModel();
        foreach (OscMessage message in Poses.Decode(Poses.Encode(encoder, Poses.Taken(frame))))
            model.Receive(message);

        Assert.Equal(1, model.Frames);
        return model;
    }
}
