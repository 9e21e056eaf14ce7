using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Frames;

public sealed class FrameFormatTests
{
    [Theory]
    [InlineData(0u, RotationOrder.XZY)]
    [InlineData(1u, RotationOrder.YXZ)]
    [InlineData(5u, RotationOrder.ZYX)]
    [InlineData(6u, null)] // the vendor's "unknown"
    [InlineData(uint.MaxValue, null)]
    public void Axis_Studio_writes_the_order_into_the_first_reserved_field(uint reserved, RotationOrder? expected)
    {
        Assert.Equal(expected, FrameFormat.ReadOrder(Header(DataVersion.Studio, reserved)));
        Assert.Null(FrameFormat.ReadOrder(Header(DataVersion.New, reserved)));
        Assert.Null(FrameFormat.ReadOrder(Header(DataVersion.Old, reserved)));
        Assert.Null(FrameFormat.ReadOrder(Header(new DataVersion(1, 1, 0, 2), reserved)));
    }

    [Fact]
    public void Option_stream_command_channel_and_default_take_precedence_in_this_order()
    {
        byte[] studio = Header(DataVersion.Studio, (uint)RotationOrder.ZXY);
        byte[] neuron = Header(DataVersion.New, (uint)RotationOrder.ZXY);
        var found = new FrameFormat(order: null, variant: null);
        Assert.Equal(SkeletonFormat.Default, found.Of(neuron));
        Assert.Equal(RotationOrder.ZXY, found.Of(studio).RotationOrder);

        found.Learn(RotationOrder.XYZ, SkeletonVariant.Spine3);
        found.Learn(null, null);
        Assert.Equal(new SkeletonFormat(RotationOrder.XYZ, SkeletonVariant.Spine3), found.Of(neuron));
        Assert.Equal(new SkeletonFormat(RotationOrder.ZXY, SkeletonVariant.Spine3), found.Of(studio));

        var given = new FrameFormat(RotationOrder.YZX, SkeletonVariant.Neck1);
        given.Learn(RotationOrder.XYZ, SkeletonVariant.Spine3);
        Assert.Equal(new SkeletonFormat(RotationOrder.YZX, SkeletonVariant.Neck1), given.Of(studio));
    }

    [Fact]
    public void Each_frame_and_its_clone_use_its_own_order()
    {
        float[] values = new float[180];
        (values[3], values[4], values[5]) = (10, 20, 30);
        var format = new FrameFormat(order: null, variant: null);
        var frame = new MotionFrame(format);
        frame.Borrow(Packet(DataVersion.New, 0, values));
        MotionFrame first = frame.Clone();
        frame.Borrow(Packet(DataVersion.Studio, (uint)RotationOrder.ZYX, values));
        MotionFrame second = frame.Clone();
        format.Learn(RotationOrder.XYZ, variant: null);

        Assert.Equal((RotationOrder.YXZ, RotationOrder.ZYX), (first.Format.RotationOrder, second.Format.RotationOrder));
        Assert.Equal(EulerAngles.ToQuaternion(new(10, 20, 30), RotationOrder.YXZ), first.GetRotation(Bone.Hips));
        Assert.Equal(EulerAngles.ToQuaternion(new(10, 20, 30), RotationOrder.ZYX), second.GetRotation(Bone.Hips));
    }

    [Theory]
    [InlineData(0x0A0B0Cu, 7u, "10:11:12:07")]
    [InlineData(0x000000u, 1u, "00:00:00:01")]
    [InlineData(0x173B3Bu, 239u, "23:59:59:239")]
    [InlineData(0x000000u, 0u, null)]
    [InlineData(0x180000u, 0u, null)]
    [InlineData(0x003C00u, 0u, null)]
    [InlineData(0x00003Cu, 0u, null)]
    [InlineData(0x01000001u, 0u, null)]
    [InlineData(0x0A0B0Cu, 1000u, null)]
    [InlineData(0x0A0B0Cu, uint.MaxValue, null)]
    public void Only_a_valid_Axis_Studio_timecode_is_read(uint time, uint subFrame, string? expected)
    {
        var header = new MotionHeader { Version = DataVersion.Studio, Reserved1 = time, Reserved2 = subFrame };
        Assert.Equal(expected, header.Timecode?.ToString());
        Assert.Equal(header.Timecode, new MotionFrame(header, new float[180]).Timecode);
        Assert.Null((header with { Version = DataVersion.New }).Timecode);
        Assert.Null((header with { Version = DataVersion.Old }).Timecode);
    }

    [Fact]
    public void The_fixtures_order_and_timecode_are_read()
    {
        byte[] stream = StreamFixture.Load("studio-354").Bytes;
        Assert.True(MotionHeader.TryRead(stream, out MotionHeader header));
        Assert.Equal(new Timecode(10, 11, 12, 7), header.Timecode);
        Assert.Equal(RotationOrder.YXZ, FrameFormat.ReadOrder(stream));
    }

    private static byte[] Header(DataVersion version, uint reserved)
    {
        byte[] header = new byte[64];
        new MotionHeader { Version = version, Reserved = reserved, Reserved1 = reserved, Reserved2 = reserved }.Write(header);
        return header;
    }

    private static ReceivedPacket Packet(DataVersion version, uint reserved, float[] values)
    {
        byte[] packet = new byte[64 + (4 * values.Length)];
        PacketEncoder.WriteMotion(packet, new MotionHeader { Version = version, Reserved = reserved }, values);
        return new ReceivedPacket(PacketKind.Motion, packet, timestamp: 0, origin: 0);
    }
}
