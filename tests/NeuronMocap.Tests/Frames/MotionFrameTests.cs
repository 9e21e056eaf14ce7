using System.Diagnostics;
using System.Numerics;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Skeleton;

namespace NeuronMocap.Tests.Frames;

public sealed class MotionFrameTests
{
    public static TheoryData<int, HeaderLayout> Layouts => new()
    {
        { 180, HeaderLayout.New }, { 186, HeaderLayout.New }, { 354, HeaderLayout.New }, { 360, HeaderLayout.New },
        { 180, HeaderLayout.Old }, { 186, HeaderLayout.Old }, { 354, HeaderLayout.Old }, { 360, HeaderLayout.Old },
    };

    [Theory, MemberData(nameof(Layouts))]
    public void Every_bone_has_its_own_values(int count, HeaderLayout layout)
    {
        float[] values = Ascending(count);
        MotionFrame frame = Lend(Packet(values, layout));
        int first = count is 186 or 360 ? 6 : 0;

        Assert.True(frame.HasSkeleton);
        Assert.Equal(count, frame.Layout.ValueCount);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            int index = (int)bone;
            bool displaced = count >= 354;
            int rotation = first + (displaced ? (6 * index) + 3 : 3 + (3 * index));
            Vector3 position = (displaced, index) switch
            {
                (true, _) => Triple(values, first + (6 * index)),
                (false, 0) => Triple(values, first),
                _ => DefaultOffsets.Get(bone),
            };

            Assert.Equal(position, frame.GetPosition(bone));
            Assert.Equal(Triple(values, rotation), frame.GetEulerAngles(bone));
            Assert.Equal(EulerAngles.ToQuaternion(Triple(values, rotation), RotationOrder.YXZ), frame.GetRotation(bone));
            Assert.Equal(new BoneTransform(frame.GetPosition(bone), frame.GetRotation(bone)), frame[bone]);
        }
    }

    [Theory, MemberData(nameof(Layouts))]
    public void The_reference_node_is_the_first_six_values_or_identity(int count, HeaderLayout layout)
    {
        float[] values = Ascending(count);
        BoneTransform reference = Lend(Packet(values, layout)).GetReference();

        if (count is 186 or 360)
            Assert.Equal(new BoneTransform(Triple(values, 0), EulerAngles.ToQuaternion(Triple(values, 3), RotationOrder.YXZ)), reference);
        else
            Assert.Equal(BoneTransform.Identity, reference);
    }

    [Theory, MemberData(nameof(Layouts))]
    public void The_header_is_returned_as_received(int count, HeaderLayout layout)
    {
        byte[] packet = layout == HeaderLayout.New
            ? GoldenPackets.NewMotion(Ascending(count), avatar: 3, name: "Header", frame: 0x80000001)
            : GoldenPackets.OldMotion(Ascending(count), avatar: 3, name: "Header");
        MotionFrame frame = Lend(packet);

        Assert.Equal(3, frame.AvatarIndex);
        Assert.Equal("Header", frame.AvatarName);
        Assert.Equal(layout == HeaderLayout.New ? 0x80000001u : null, frame.FrameIndex);
        Assert.True(MotionHeader.TryRead(packet, out MotionHeader header));
        Assert.Equal(header, frame.Header);
        Assert.Equal(Ascending(count), frame.Values.ToArray());
    }

    // Flags that contradict the count: the count determines the layout, and the header still contains the flags.
    [Theory]
    [InlineData(180, true, true)]
    [InlineData(186, true, false)]
    [InlineData(354, false, true)]
    [InlineData(360, false, false)]
    public void The_value_count_decides_not_the_flags(int count, bool displacement, bool reference)
    {
        MotionFrame frame = Lend(GoldenPackets.NewMotion(Ascending(count), displacement: displacement, reference: reference));

        Assert.Equal(new ChannelLayout(count >= 354, count is 186 or 360), frame.Layout);
        Assert.Equal((displacement, reference), (frame.Header.HasDisplacement, frame.Header.HasReference));
        Assert.Equal(Triple(frame.Values, count is 186 or 360 ? 6 : 0), frame.GetPosition(Bone.Hips));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(100)]
    [InlineData(353)]
    [InlineData(355)]
    public void A_frame_of_an_unknown_value_count_has_no_skeleton(int count)
    {
        MotionFrame frame = Lend(GoldenPackets.NewMotion(Ascending(count), avatar: 1));
        BoneTransform[] room = new BoneTransform[59];

        Assert.False(frame.HasSkeleton);
        Assert.Equal(Ascending(count), frame.Values.ToArray());
        Assert.Equal(1, frame.AvatarIndex);
        Assert.Throws<InvalidOperationException>(() => frame.Layout);
        Assert.Throws<InvalidOperationException>(() => frame[Bone.Hips]);
        Assert.Throws<InvalidOperationException>(() => frame.GetPosition(Bone.Hips));
        Assert.Throws<InvalidOperationException>(() => frame.GetEulerAngles(Bone.Hips));
        Assert.Throws<InvalidOperationException>(() => frame.GetRotation(Bone.Hips));
        Assert.Throws<InvalidOperationException>(() => frame.GetReference());
        Assert.Throws<InvalidOperationException>(() => frame.CopyLocalTransforms(room));
        Assert.Throws<InvalidOperationException>(() => frame.CopyWorldTransforms(room));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(59)]
    public void An_unknown_bone_is_refused(int number)
    {
        foreach (int count in (int[])[180, 354])
        {
            MotionFrame frame = Lend(GoldenPackets.NewMotion(Ascending(count)));
            Assert.Throws<ArgumentOutOfRangeException>(() => frame.GetPosition((Bone)number));
            Assert.Throws<ArgumentOutOfRangeException>(() => frame.GetEulerAngles((Bone)number));
            Assert.Throws<ArgumentOutOfRangeException>(() => frame[(Bone)number]);
        }
    }

    [Fact]
    public void The_format_decides_order_and_offsets()
    {
        float[] values = new float[180];
        (values[3], values[4], values[5]) = (10, 20, 30);
        foreach (RotationOrder order in Enum.GetValues<RotationOrder>())
        {
            var format = new SkeletonFormat(order, SkeletonVariant.Spine3);
            MotionFrame frame = Lend(GoldenPackets.NewMotion(values), format);

            Assert.Equal(format, frame.Format);
            Assert.True(ReferenceRotation.FromAngles(new Vector3(10, 20, 30), order).Distance(frame.GetRotation(Bone.Hips)) < 1e-6);
            Assert.Equal(new Vector3(0, 13.47f, 0), frame.GetPosition(Bone.Spine));
        }
    }

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void World_transforms_include_the_Reference_node_and_follow_the_variant(SkeletonVariant variant)
    {
        float[] values = Ascending(360);
        MotionFrame frame = Lend(GoldenPackets.NewMotion(values), new SkeletonFormat(RotationOrder.ZXY, variant));
        BoneTransform[] local = new BoneTransform[59];
        BoneTransform[] expected = new BoneTransform[59];
        BoneTransform[] world = new BoneTransform[59];

        frame.CopyLocalTransforms(local);
        frame.CopyWorldTransforms(world);
        ForwardKinematics.ToWorld(local, expected, variant, frame.GetReference());

        Assert.All(BoneHierarchy.Bones.ToArray(), bone => Assert.Equal(frame[bone], local[(int)bone]));
        Assert.Equal(expected, world);
        Assert.NotEqual(local[0], world[0]);
    }

    [Theory]
    [InlineData(180)]
    [InlineData(186)]
    [InlineData(354)]
    [InlineData(360)]
    public void A_body_supplies_missing_positions(int count)
    {
        MotionFrame frame = Lend(GoldenPackets.NewMotion(Ascending(count)));
        var body = SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure() with { UpperArm = 0.4f }, SkeletonVariant.Spine3);
        BoneTransform[] local = new BoneTransform[59];
        BoneTransform[] world = new BoneTransform[59];
        BoneTransform[] expected = new BoneTransform[59];

        frame.CopyLocalTransforms(local, body);
        frame.CopyWorldTransforms(world, body);

        foreach (Bone bone in BoneHierarchy.Bones)
        {
            bool isCarried = frame.Layout.GetPositionIndex(bone) >= 0;
            Assert.Equal(isCarried ? frame.GetPosition(bone) : body.GetOffset(bone), local[(int)bone].Position);
            Assert.Equal(frame.GetRotation(bone), local[(int)bone].Rotation);
        }

        ForwardKinematics.ToWorld(local, expected, SkeletonVariant.Spine3, frame.GetReference());
        Assert.Equal(expected, world);
        Assert.Throws<ArgumentNullException>(() => frame.CopyWorldTransforms(world, null!));
    }

    [Fact]
    public void Less_room_than_59_transforms_is_refused()
    {
        MotionFrame frame = Lend(GoldenPackets.NewMotion(Ascending(354)));
        Assert.Throws<ArgumentException>(() => frame.CopyLocalTransforms(new BoneTransform[58]));
        Assert.Throws<ArgumentException>(() => frame.CopyWorldTransforms(new BoneTransform[58]));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void An_unaligned_packet_is_read_alike(int offset)
    {
        byte[] packet = GoldenPackets.NewMotion(Ascending(360), name: "Odd");
        MotionFrame even = Lend(packet);
        MotionFrame odd = Lend(packet, offset: offset);

        Assert.Equal(even.Values.ToArray(), odd.Values.ToArray());
        Assert.Equal(even.Header, odd.Header);
        Assert.All(BoneHierarchy.Bones.ToArray(), bone => Assert.Equal(even[bone], odd[bone]));
    }

    [Fact]
    public void Only_a_clone_is_independent_of_the_buffer()
    {
        byte[] buffer = GoldenPackets.NewMotion(Ascending(354), avatar: 1, name: "Before", frame: 7);
        var frame = new MotionFrame(SkeletonFormat.Default);
        frame.Borrow(new ReceivedPacket(PacketKind.Motion, buffer, timestamp: 123, origin: 4));
        MotionFrame clone = frame.Clone();
        MotionFrame cloneOfClone = clone.Clone();

        GoldenPackets.NewMotion(new float[180], avatar: 2, name: "After", frame: 8).CopyTo(buffer, 0);
        frame.Borrow(new ReceivedPacket(PacketKind.Motion, new ArraySegment<byte>(buffer, 0, 784), timestamp: 456, origin: 5));

        Assert.Equal((2, "After", 8u, 456L, 5), (frame.AvatarIndex, frame.AvatarName, frame.FrameIndex, frame.Timestamp, frame.Sender));
        Assert.Equal(180, frame.Layout.ValueCount);
        foreach (MotionFrame kept in (MotionFrame[])[clone, cloneOfClone])
        {
            Assert.Equal((1, "Before", 7u, 123L, 4), (kept.AvatarIndex, kept.AvatarName, kept.FrameIndex, kept.Timestamp, kept.Sender));
            Assert.Equal(Ascending(354), kept.Values.ToArray());
            Assert.Equal(354, kept.Layout.ValueCount);
        }
    }

    [Fact]
    public void A_reused_frame_forgets_the_previous_packet()
    {
        var frame = new MotionFrame(SkeletonFormat.Default);
        foreach (int count in (int[])[354, 100, 180, 0, 360])
        {
            frame.Borrow(new ReceivedPacket(PacketKind.Motion, GoldenPackets.NewMotion(Ascending(count)), 0, 0));
            Assert.Equal(count, frame.Values.Length);
            Assert.Equal(ChannelLayout.TryFromValueCount(count, out _), frame.HasSkeleton);
        }
    }

    [Theory]
    [InlineData(1, 1, HeaderLayout.New)]
    [InlineData(1, 0, HeaderLayout.Old)]
    [InlineData(0, 0, HeaderLayout.Old)] // none: text frames, and default(MotionHeader)
    public void A_frame_can_be_created_without_a_stream(byte major, byte minor, HeaderLayout layout)
    {
        float[] values = Ascending(354);
        long before = Stopwatch.GetTimestamp();
        var frame = new MotionFrame(
            new MotionHeader
            {
                Version = new DataVersion(major, minor, 0, 0),
                ValueCount = 7,
                HasDisplacement = true,
                AvatarIndex = 6,
                AvatarName = new AvatarName("Made"),
                FrameIndex = 5,
            },
            values);
        values[0] = -1;

        Assert.Equal(layout, frame.Header.Layout);
        Assert.Equal((354, 6, "Made"), (frame.Header.ValueCount, frame.AvatarIndex, frame.AvatarName));
        Assert.Equal(layout == HeaderLayout.New ? 5u : null, frame.FrameIndex);
        Assert.Equal(Ascending(354), frame.Values.ToArray());
        Assert.Equal(SkeletonFormat.Default, frame.Format);
        Assert.InRange(frame.Timestamp, before, Stopwatch.GetTimestamp());
        Assert.True(frame.Age >= TimeSpan.Zero);
        Assert.Equal(0, frame.Sender);
    }

    [Fact]
    public void More_values_than_the_header_counts_are_refused() =>
        Assert.Throws<InvalidOperationException>(() => new MotionFrame(new MotionHeader(), new float[65_536]));

    [Fact]
    public void Equal_names_share_a_string()
    {
        MotionFrame first = Lend(GoldenPackets.NewMotion(new float[180], name: "Cached"));
        MotionFrame second = Lend(GoldenPackets.OldMotion(new float[354], name: "Cached"));
        CalculationFrame third = new(new CalculationHeader { AvatarName = new AvatarName("Cached") }, new float[338]);

        Assert.Equal("Cached", first.AvatarName);
        Assert.Same(first.AvatarName, first.AvatarName);
        Assert.Same(first.AvatarName, second.AvatarName);
        Assert.Same(first.AvatarName, third.AvatarName);
    }

    [Theory, MemberData(nameof(Layouts))]
    public void Reading_a_frame_allocates_nothing(int count, HeaderLayout layout)
    {
        byte[] packet = Packet(Ascending(count), layout);
        var frame = new MotionFrame(SkeletonFormat.Default);
        BoneTransform[] world = new BoneTransform[59];
        float sum = 0;
        Allocations.AssertNone(() =>
        {
            frame.Borrow(new ReceivedPacket(PacketKind.Motion, packet, 0, 0));
            foreach (Bone bone in BoneHierarchy.Bones)
                sum += frame.GetRotation(bone).W + frame.GetPosition(bone).X + frame.GetEulerAngles(bone).X + frame[bone].Position.Y;

            frame.CopyWorldTransforms(world);
            sum += world[58].Position.X + frame.Values[0] + frame.AvatarName.Length + frame.Header.PacketSize + frame.GetReference().Position.X;
        });
        Assert.NotEqual(0, sum);
    }

    internal static MotionFrame Lend(byte[] packet, SkeletonFormat? format = null, int offset = 0)
    {
        byte[] buffer = new byte[offset + packet.Length + 5];
        packet.CopyTo(buffer, offset);
        var frame = new MotionFrame(format ?? SkeletonFormat.Default);
        var lent = new ArraySegment<byte>(buffer, offset, packet.Length);
        frame.Borrow(new ReceivedPacket(PacketKind.Motion, lent, Stopwatch.GetTimestamp(), origin: 0));
        return frame;
    }

    internal static Vector3 Triple(ReadOnlySpan<float> values, int index) => new(values[index], values[index + 1], values[index + 2]);

    private static byte[] Packet(float[] values, HeaderLayout layout) =>
        layout == HeaderLayout.New ? GoldenPackets.NewMotion(values) : GoldenPackets.OldMotion(values);

    private static float[] Ascending(int count) => [.. Enumerable.Range(0, count).Select(index => index + 0.25f)];
}
