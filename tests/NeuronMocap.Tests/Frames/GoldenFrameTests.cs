using System.Numerics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Skeleton;

namespace NeuronMocap.Tests.Frames;

/// <summary>
/// The published figures of a frame from an Axis Studio (protocol.md section 3.2): the bones in the table, and zero for the others.
/// </summary>
public sealed class GoldenFrameTests
{
    private static readonly (int Index, Vector3 Position, Vector3 Angles)[] Table =
    [
        (0, new(-1.1474f, 96.5926f, 7.0751f), new(167.9936f, -179.7707f, 179.8350f)),
        (1, new(-11, 0, 0), new(3.0911f, 1.1112f, -2.5818f)),
        (2, new(0, -45, 0), new(150.7841f, 172.3932f, 179.2685f)),
        (3, new(0, -42, 0), new(4.8600f, -5.5446f, 1.7724f)),
        (4, new(11, 0, 0), new(168.0627f, -176.7370f, -179.3114f)),
        (7, new(0, 8.12f, 0), new(0.3363f, 2.1692f, -0.2728f)),
        (10, new(0, 19.14f, 0), new(180, -174.6910f, -177.0637f)),
        (14, new(-16.1f, 0, 0), new(7.1629f, -4.8713f, 69.2438f)),
        (58, new(1.891f, 0, 0), new(0, -0f, -24.842f)),
    ];

    [Fact]
    public void The_header_is_read()
    {
        MotionFrame frame = GoldenFrame();

        Assert.True(frame.HasSkeleton);
        Assert.Equal("1.1.0.1", frame.Header.Version.ToString());
        Assert.Equal((0, "chr00", 2u), (frame.AvatarIndex, frame.AvatarName, frame.FrameIndex));
        Assert.Equal((1u, 0u, 0u), (frame.Header.Reserved, frame.Header.Reserved1, frame.Header.Reserved2));
        Assert.Equal(new ChannelLayout(hasDisplacement: true, hasReference: false), frame.Layout);
    }

    [Theory]
    [InlineData(Bone.Hips, 0)]
    [InlineData(Bone.RightUpLeg, 1)]
    [InlineData(Bone.RightLeg, 2)]
    [InlineData(Bone.RightFoot, 3)]
    [InlineData(Bone.LeftUpLeg, 4)]
    [InlineData(Bone.Spine, 5)]
    [InlineData(Bone.Neck, 6)]
    [InlineData(Bone.RightArm, 7)]
    [InlineData(Bone.LeftHandPinky3, 8)]
    public void Every_bone_has_the_values_of_the_table(Bone bone, int row)
    {
        MotionFrame frame = GoldenFrame();

        Assert.Equal(Table[row].Position, frame.GetPosition(bone));
        Assert.Equal(Table[row].Angles, frame.GetEulerAngles(bone));
        Assert.True(ReferenceRotation.FromAngles(Table[row].Angles, RotationOrder.YXZ).Distance(frame.GetRotation(bone)) < 1e-6);
    }

    [Fact]
    public void Hips_angles_near_180_are_a_small_rotation()
    {
        Quaternion small = EulerAngles.ToQuaternion(new Vector3(-12.0064f, -0.2293f, -0.1650f), RotationOrder.YXZ);
        Assert.Equal(1, Math.Abs(Quaternion.Dot(small, GoldenFrame().GetRotation(Bone.Hips))), 1e-6f);
    }

    [Fact]
    public void Negative_zero_is_kept() => Assert.True(float.IsNegative(GoldenFrame().GetEulerAngles(Bone.LeftHandPinky3).Y));

    private static MotionFrame GoldenFrame()
    {
        float[] values = new float[354];
        foreach ((int index, Vector3 position, Vector3 angles) in Table)
        {
            position.CopyTo(values, 6 * index);
            angles.CopyTo(values, (6 * index) + 3);
        }

        byte[] packet = new WireBytes()
            .Hex("FF DD  01 00 01 01  62 01  01  00  00 00 00 00").Ascii("chr00", 32)
            .Hex("02 00 00 00  01 00 00 00  00 00 00 00  00 00 00 00  FF EE")
            .Floats(values)
            .ToArray();
        return MotionFrameTests.Lend(packet);
    }
}
