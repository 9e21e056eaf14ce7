using System.Numerics;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Skeleton;

namespace NeuronMocap.Tests.Frames;

public sealed class CalculationFrameTests
{
    [Fact]
    public void The_two_lengths_match_the_manual()
    {
        Assert.Equal(338, CalculationFrame.BodyValueCount);
        Assert.Equal(946, CalculationFrame.FullValueCount);
    }

    // The first value of bones of Appendix C: 16 for each bone before it and, after the body, two contact flags.
    [Theory]
    [InlineData(946, Bone.Hips, 0)]
    [InlineData(946, Bone.RightUpLeg, 16)]
    [InlineData(946, Bone.Head, 240)]
    [InlineData(946, Bone.Spine, 320)]
    [InlineData(946, Bone.RightHandThumb1, 338)]
    [InlineData(946, Bone.RightHandThumb2, 354)]
    [InlineData(946, Bone.LeftHandPinky3, 930)]
    [InlineData(338, Bone.Hips, 0)]
    [InlineData(338, Bone.Spine, 320)]
    public void A_bones_sixteen_values_are_position_velocity_quaternion_acceleration_and_gyro(int count, Bone bone, int first)
    {
        CalculationFrame frame = Lend(GoldenPackets.CalculationData(Ascending(count)));
        float[] v = Ascending(count)[first..(first + 16)];

        Assert.Equal(new Vector3(v[0], v[1], v[2]), frame.GetPosition(bone));
        Assert.Equal(new Vector3(v[3], v[4], v[5]), frame.GetVelocity(bone));
        Assert.Equal(new Quaternion(x: v[7], y: v[8], z: v[9], w: v[6]), frame.GetSensorRotation(bone));
        Assert.Equal(new Vector3(v[10], v[11], v[12]), frame.GetAcceleration(bone));
        Assert.Equal(new Vector3(v[13], v[14], v[15]), frame.GetAngularVelocity(bone));
    }

    [Fact]
    public void Every_bone_of_Appendix_C_has_its_own_sixteen_values()
    {
        CalculationFrame frame = Lend(GoldenPackets.CalculationData(Ascending(946)));
        for (int place = 0; place < 59; place++)
        {
            Bone bone = Enum.Parse<Bone>(ManualTables.AppendixC[place]);
            int first = (16 * place) + (place < 21 ? 0 : 2);
            Assert.Equal(first + 0.25f, frame.GetPosition(bone).X);
            Assert.Equal(first + 15.25f, frame.GetAngularVelocity(bone).Z);
        }
    }

    [Theory]
    [InlineData(338, 0, 0)]
    [InlineData(338, 1, 0)]
    [InlineData(338, 0, 1)]
    [InlineData(946, 1, 1)]
    [InlineData(946, 0, 1)]
    [InlineData(946, 1, 0)]
    public void Contact_flags_follow_the_body_left_first(int count, int left, int right)
    {
        float[] values = [.. Enumerable.Repeat(9f, count)];
        (values[336], values[337]) = (left, right);
        CalculationFrame frame = Lend(GoldenPackets.CalculationData(values));

        Assert.Equal(left == 1, frame.LeftFootContact);
        Assert.Equal(right == 1, frame.RightFootContact);
    }

    [Theory]
    [InlineData(338, 21)]
    [InlineData(946, 59)]
    [InlineData(0, 0)]
    [InlineData(336, 0)]
    [InlineData(337, 0)]
    [InlineData(339, 0)]
    [InlineData(944, 0)]
    public void The_value_count_decides_the_bones(int count, int bones)
    {
        CalculationFrame frame = Lend(GoldenPackets.CalculationData(Ascending(count)));

        Assert.Equal(bones, frame.BoneCount);
        Assert.Equal(Ascending(count), frame.Values.ToArray());
        for (int place = 0; place < 59; place++)
            Assert.Equal(place < bones, frame.Contains(Enum.Parse<Bone>(ManualTables.AppendixC[place])));
    }

    [Theory]
    [InlineData(338, Bone.RightHandThumb1)]
    [InlineData(338, Bone.LeftHandPinky3)]
    [InlineData(0, Bone.Hips)]
    [InlineData(337, Bone.Hips)]
    public void A_missing_bone_is_refused(int count, Bone bone)
    {
        CalculationFrame frame = Lend(GoldenPackets.CalculationData(Ascending(count)));

        Assert.Throws<InvalidOperationException>(() => frame.GetPosition(bone));
        Assert.Throws<InvalidOperationException>(() => frame.GetVelocity(bone));
        Assert.Throws<InvalidOperationException>(() => frame.GetSensorRotation(bone));
        Assert.Throws<InvalidOperationException>(() => frame.GetAcceleration(bone));
        Assert.Throws<InvalidOperationException>(() => frame.GetAngularVelocity(bone));
    }

    [Fact]
    public void Contacts_of_a_frame_without_bones_are_refused()
    {
        CalculationFrame frame = Lend(GoldenPackets.CalculationData(Ascending(337)));
        Assert.Throws<InvalidOperationException>(() => frame.LeftFootContact);
        Assert.Throws<InvalidOperationException>(() => frame.RightFootContact);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(59)]
    public void An_unknown_bone_is_refused(int number)
    {
        CalculationFrame frame = Lend(GoldenPackets.CalculationData(Ascending(946)));
        Assert.Throws<ArgumentOutOfRangeException>(() => frame.Contains((Bone)number));
        Assert.Throws<ArgumentOutOfRangeException>(() => frame.GetPosition((Bone)number));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void An_unaligned_packet_is_read_alike(int offset)
    {
        byte[] packet = GoldenPackets.CalculationData(Ascending(946));
        CalculationFrame odd = Lend(packet, offset);

        Assert.Equal(Ascending(946), odd.Values.ToArray());
        Assert.Equal(Lend(packet).Header, odd.Header);
        Assert.Equal(930.25f, odd.GetPosition(Bone.LeftHandPinky3).X);
    }

    [Fact]
    public void Only_a_clone_is_independent_of_the_buffer()
    {
        byte[] buffer = GoldenPackets.CalculationData(Ascending(946), avatar: 1, name: "Before", frame: 7);
        var frame = new CalculationFrame();
        frame.Borrow(new ReceivedPacket(PacketKind.Calculation, buffer, timestamp: 123, origin: 4));
        CalculationFrame clone = frame.Clone();

        GoldenPackets.CalculationData(new float[338], avatar: 2, name: "After", frame: 8).CopyTo(buffer, 0);
        frame.Borrow(new ReceivedPacket(PacketKind.Calculation, new ArraySegment<byte>(buffer, 0, 1416), timestamp: 456, origin: 5));

        Assert.Equal((2, "After", 8u, 456L, 5), (frame.AvatarIndex, frame.AvatarName, frame.FrameIndex, frame.Timestamp, frame.Sender));
        Assert.Equal(21, frame.BoneCount);
        Assert.Equal((1, "Before", 7u, 123L, 4), (clone.AvatarIndex, clone.AvatarName, clone.FrameIndex, clone.Timestamp, clone.Sender));
        Assert.Equal(Ascending(946), clone.Values.ToArray());
        Assert.Equal(59, clone.BoneCount);
    }

    [Fact]
    public void A_frame_can_be_created_without_a_stream()
    {
        var header = new CalculationHeader { ValueCount = 7, AvatarIndex = 6, AvatarName = new AvatarName("Made"), FrameIndex = 5, Reserved3 = 4 };
        var frame = new CalculationFrame(header, Ascending(338));

        Assert.Equal(header with { ValueCount = 338 }, frame.Header);
        Assert.Equal((6, "Made", 5u), (frame.AvatarIndex, frame.AvatarName, frame.FrameIndex));
        Assert.Equal(Ascending(338), frame.Values.ToArray());
    }

    [Fact]
    public void Frames_of_the_test_encoder_are_read()
    {
        StreamFixture fixture = StreamFixture.Load("calculation");
        var scan = ScanAll.Of(fixture.Bytes);
        Assert.Equal(2, scan.Packets.Count);
        for (int i = 0; i < 2; i++)
        {
            CalculationFrame frame = Lend(scan.Packets[i].Bytes);
            float[] values = fixture.Expected[i].Values;

            Assert.Equal(fixture.Expected[i].Name, frame.AvatarName);
            Assert.Equal(values[336] != 0, frame.LeftFootContact);
            Assert.Equal(values[337] != 0, frame.RightFootContact);
            for (int place = 0; place < frame.BoneCount; place++)
            {
                Bone bone = Enum.Parse<Bone>(ManualTables.AppendixC[place]);
                Assert.Equal(values[(16 * place) + (place < 21 ? 0 : 2)], frame.GetPosition(bone).X);
            }
        }
    }

    [Fact]
    public void Reading_a_frame_allocates_nothing()
    {
        byte[] packet = GoldenPackets.CalculationData(Ascending(946));
        var frame = new CalculationFrame();
        float sum = 0;
        Allocations.AssertNone(() =>
        {
            frame.Borrow(new ReceivedPacket(PacketKind.Calculation, packet, 0, 0));
            foreach (Bone bone in BoneHierarchy.Bones)
                sum += frame.GetPosition(bone).X + frame.GetVelocity(bone).X + frame.GetSensorRotation(bone).W + frame.GetAcceleration(bone).X;

            sum += frame.AvatarName.Length + frame.Values[0] + (frame.LeftFootContact ? 1 : 0) + frame.Header.PacketSize;
        });
        Assert.NotEqual(0, sum);
    }

    private static CalculationFrame Lend(byte[] packet, int offset = 0)
    {
        byte[] buffer = new byte[offset + packet.Length + 5];
        packet.CopyTo(buffer, offset);
        var frame = new CalculationFrame();
        frame.Borrow(new ReceivedPacket(PacketKind.Calculation, new ArraySegment<byte>(buffer, offset, packet.Length), timestamp: 0, origin: 0));
        return frame;
    }

    private static float[] Ascending(int count) => [.. Enumerable.Range(0, count).Select(index => index + 0.25f)];
}
