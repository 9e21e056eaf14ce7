using System.Buffers.Binary;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Frames;

public sealed class StudioCalculationFrameTests
{
    [Fact]
    public void Every_field_of_every_bone_is_read()
    {
        byte[] packet = StreamFixture.Load("studio-calculation").Bytes;
        Assert.True(StudioCalculationHeader.TryRead(packet, out StudioCalculationHeader header));
        Assert.Equal((4956, 9u, 0u, 0xFEu, 5020), (header.ByteCount, header.FrameIndex, header.Category, header.DataMask, header.PacketSize));

        var frame = new StudioCalculationFrame(header, packet.AsSpan(64));
        StudioCalculations.AssertFixture(frame);
        StudioCalculations.AssertFixture(frame.Clone());
        Assert.Equal(packet[64..], frame.Payload.ToArray());
    }

    [Theory]
    [InlineData(4956, 0xFEu, 2, true)]
    [InlineData(4956, 0xFFu, 2, false)]
    [InlineData(4956, 0x7Eu, 2, false)]
    [InlineData(4956, 0u, 2, false)]
    [InlineData(4956, 0xFEu, 3, false)]
    [InlineData(4952, 0xFEu, 2, false)]
    [InlineData(4957, 0xFEu, 2, false)]
    [InlineData(3, 0xFEu, 2, false)]
    [InlineData(1764, 0xFEu, 2, false)]
    public void An_unknown_mask_size_or_version_gives_only_bytes(int size, uint mask, int major, bool isKnown)
    {
        byte[] payload = new byte[size];
        new Random(1).NextBytes(payload);
        var header = new StudioCalculationHeader { Version = new DataVersion((byte)major, 0, 0, 0), DataMask = mask };
        var frame = new StudioCalculationFrame(header, payload);

        Assert.Equal(isKnown, frame.HasSkeleton);
        Assert.Equal(payload, frame.Payload.ToArray());
        Assert.Equal(size / 4, frame.Values.Length);
        if (!isKnown)
            Assert.Throws<InvalidOperationException>(() => frame.GetPosition(Bone.Hips));
    }

    [Fact]
    public void An_unknown_bone_is_refused()
    {
        var frame = new StudioCalculationFrame(new StudioCalculationHeader(), new byte[StudioCalculationFrame.FullByteCount]);
        Assert.Throws<ArgumentOutOfRangeException>(() => frame.GetPosition((Bone)59));
        Assert.Throws<ArgumentOutOfRangeException>(() => frame.IsSensorLost((Bone)(-1)));
    }

    [Fact]
    public void A_reused_frame_forgets_the_previous_one()
    {
        var frame = new StudioCalculationFrame();
        byte[] known = TestPackets.Studio(1);
        frame.Borrow(new ReceivedPacket(PacketKind.StudioCalculation, known, timestamp: 1, origin: 2));
        StudioCalculationFrame kept = frame.Clone();
        frame.Borrow(new ReceivedPacket(PacketKind.StudioCalculation, TestPackets.Studio(2, avatar: 3, bones: 21), timestamp: 3, origin: 4));

        Assert.Equal((false, 2u, 3, 4), (frame.HasSkeleton, frame.FrameIndex, frame.AvatarIndex, frame.Sender));
        Assert.Equal((true, 1u, 0, 2), (kept.HasSkeleton, kept.FrameIndex, kept.AvatarIndex, kept.Sender));
        Assert.Equal(TestPackets.Value(1, 0, (84 / 4 * 12) + 13), kept.GetPosition(Bone.Head).X);
    }

    [Fact]
    public void Reading_a_frame_allocates_nothing()
    {
        byte[] packet = TestPackets.Studio(1);
        var frame = new StudioCalculationFrame();
        float sum = 0;
        Allocations.AssertNone(() =>
        {
            frame.Borrow(new ReceivedPacket(PacketKind.StudioCalculation, packet, timestamp: 0, origin: 0));
            foreach (Bone bone in BoneHierarchy.Bones)
                sum += frame.GetPosition(bone).X + frame.GetBoneRotation(bone).W + frame.GetSensorRotation(bone).X + (frame.IsSensorLost(bone) ? 1 : 0);
        });
        Assert.NotEqual(0, sum);
    }

    [Fact]
    public void The_size_is_checked_before_buffering()
    {
        byte[] packet = TestPackets.Studio(1);
        BinaryPrimitives.WriteUInt32LittleEndian(packet.AsSpan(6), 4 * 1240);
        Assert.Equal(ScanStatus.Skipped, new PacketScanner(1239).Scan(packet).Status);
        BinaryPrimitives.WriteUInt32LittleEndian(packet.AsSpan(6), 4 * 1239);
        Assert.Equal(new ScanResult(ScanStatus.Packet, 5020, PacketKind.StudioCalculation), new PacketScanner(1239).Scan(packet));
        BinaryPrimitives.WriteUInt32LittleEndian(packet.AsSpan(6), uint.MaxValue);
        Assert.Equal(SkipReason.TooLarge, new PacketScanner(1_000_000).Scan(packet).Reason);
        Assert.False(StudioCalculationHeader.TryRead(packet, out _));
    }
}
