using System.Buffers.Binary;
using System.Numerics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Retargeting;

namespace NeuronMocap.Tests.Frames;

public sealed class CompactPoseTests
{
    // Written by a Python program in double precision, from the description of the format: struct.pack and square roots.
    private const string Vector =
        "010104000300000040222018240A0600040302010000803F000000C00000003F84F24FDE355436DBD1E89B4D889E78E1442FEC4DD95BBC709DE100C000407456E7"
        + "6C531EBC18A253D14900C0455C224E6E0F9F1F4958416900406E0C2FD5D1AA5F6A0040B132E37BF0A108CF084F93D893D86D2774F8219E004077CF65EE1221028B"
        + "54E3AA5161529F2DF26D004000C04D76CA5500401B356B146B141B35DDD823274C65BA15174E3B633E9B3E9B3E1B06E4FDAD0040368500C084578CB274CD8C322F"
        + "97CAA4653296F35099CB5900C0E6FA0040171FE960DD16DD58DD584C650040567CD5217550171F3A487607004099158AE58A65ED6E80672B4DEB1156AEAC9CAA51"
        + "D1E865B2CA24919000C0004000C0C2B08321A287D1A3174E92F06E8FCF2FE3AB396848729F1F0040B727C25D7C04E14E00408018C053442F442FE626D3A85AEEA6"
        + "115EF15EF100406A8C5099CB5900C083A1C230A4EE57B4A94B49E900C0865BD0ACD0AC0040E95AE95AE910C797E32BB80D19938C29AD61645F645FD9475A6FC3AB";

    private static readonly CompactPoseHeader Header = new()
    {
        AvatarIndex = 3,
        AvatarName = new AvatarName("Zoë"),
        FrameIndex = 0x01020304,
        Time = new DateTimeOffset(1970, 1, 1, 0, 0, 0, TimeSpan.Zero).AddTicks(17_000_000_001_234_567),
    };

    [Fact]
    public void The_bytes_are_those_of_another_program() => Assert.Equal(Vector, Hex(Encode(Header, VectorPose())));

    [Fact]
    public void The_bytes_of_another_program_are_decoded()
    {
        byte[] bytes = [.. Enumerable.Range(0, Vector.Length / 2).Select(static i => Convert.ToByte(Vector.Substring(2 * i, 2), 16))];
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        Assert.True(CompactPose.TryDecode(bytes, out CompactPoseHeader header, pose));
        Assert.Equal(Header with { Time = Header.Time.AddTicks(-7) }, header);
        Assert.Equal(new Vector3(1, -2, 0.5f), pose[0].Position);
        BoneTransform[] expected = VectorPose();
        for (int bone = 0; bone < pose.Length; bone++)
            Assert.InRange(Degrees(expected[bone].Rotation, pose[bone].Rotation), 0, 0.01);
    }

    [Fact]
    public void Every_rotation_is_within_a_hundredth_of_a_degree()
    {
        var random = new Random(5);
        BoneTransform[] decoded = new BoneTransform[BoneHierarchy.BoneCount];
        double worst = 0;
        double worstOfPage = 0;
        for (int i = 0; i < 500; i++)
        {
            BoneTransform[] pose = RandomPoses.Pose(random);
            byte[] bytes = Encode(Header, pose);
            Assert.True(CompactPose.TryDecode(bytes, out _, decoded));
            for (int bone = 0; bone < decoded.Length; bone++)
            {
                worst = Math.Max(worst, Degrees(pose[bone].Rotation, decoded[bone].Rotation));
                worstOfPage = Math.Max(worstOfPage, Degrees(DecodeAsOnPage(bytes, bone), decoded[bone].Rotation));
            }
        }

        Assert.InRange(worst, 0, 0.01);
        Assert.InRange(worstOfPage, 0, 0.0001);
    }

    [Theory]
    [InlineData(0, SkeletonVariant.Neck1, 0u)]
    [InlineData(1, SkeletonVariant.Spine3, null)]
    [InlineData(31, SkeletonVariant.Neck1, uint.MaxValue)]
    [InlineData(32, SkeletonVariant.Spine3, 7u)]
    public void The_header_is_kept(int nameLength, SkeletonVariant variant, uint? frameIndex)
    {
        foreach (DateTimeOffset time in (DateTimeOffset[])[DateTimeOffset.MinValue, new(2026, 11, 23, 7, 0, 0, TimeSpan.FromHours(2)), DateTimeOffset.MaxValue.AddTicks(-9)])
        {
            var header = new CompactPoseHeader
            {
                AvatarIndex = int.MinValue,
                AvatarName = new AvatarName(new string('x', nameLength)),
                FrameIndex = frameIndex,
                Time = time,
                Variant = variant,
            };
            BoneTransform[] rest = RestPose(variant);
            byte[] bytes = Encode(header, rest);
            Assert.Equal(386 + nameLength, bytes.Length);
            BoneTransform[] decoded = new BoneTransform[BoneHierarchy.BoneCount];
            Assert.True(CompactPose.TryDecode(bytes, out CompactPoseHeader read, decoded));
            Assert.Equal(header with { Time = time.ToUniversalTime() }, read);

            // The rest pose is exact, and other positions are those of the body.
            Assert.Equal(rest, decoded);
        }
    }

    [Fact]
    public void The_largest_pose_has_less_than_500_bytes() => Assert.InRange(CompactPose.MaxSize, 386, 499);

    [Fact]
    public void A_frame_is_encoded_with_its_reference_in_the_world()
    {
        var random = new Random(7);
        float[] values = [.. Enumerable.Range(0, 186).Select(_ => (random.NextSingle() * 360) - 180)];
        var header = new MotionHeader { HasReference = true, AvatarIndex = 2, AvatarName = new AvatarName("Ann"), FrameIndex = 9 };
        var frame = new MotionFrame(header, values);
        byte[] bytes = new byte[CompactPose.MaxSize];
        Assert.True(CompactPose.TryEncode(frame, bytes, out int length));
        BoneTransform[] decoded = new BoneTransform[BoneHierarchy.BoneCount];
        Assert.True(CompactPose.TryDecode(bytes.AsSpan(0, length), out CompactPoseHeader read, decoded));
        Assert.Equal((2, "Ann", 9u), (read.AvatarIndex, read.AvatarName.ToString(), read.FrameIndex));
        Assert.InRange(read.Time, DateTimeOffset.UtcNow - Limits.Unexpected, DateTimeOffset.UtcNow + Limits.Unexpected);

        BoneTransform[] expected = new BoneTransform[BoneHierarchy.BoneCount];
        frame.CopyWorldTransforms(expected);
        ForwardKinematics.ToWorld(decoded, decoded);
        Assert.Equal(expected[0].Position, decoded[0].Position);
        for (int bone = 0; bone < decoded.Length; bone++)
            Assert.InRange(Degrees(expected[bone].Rotation, decoded[bone].Rotation), 0, 0.05);
    }

    [Fact]
    public void A_pose_that_is_not_finite_is_not_encoded()
    {
        byte[] bytes = new byte[CompactPose.MaxSize];
        foreach (float bad in (float[])[float.NaN, float.PositiveInfinity, float.NegativeInfinity, float.MaxValue])
        {
            BoneTransform[] pose = RestPose();
            pose[58] = pose[58] with { Rotation = new Quaternion(0, bad, 0, 1) };
            Assert.False(CompactPose.TryEncode(Header, pose, bytes, out int length));
            Assert.Equal(0, length);
        }

        BoneTransform[] still = RestPose();
        still[7] = default;
        Assert.False(CompactPose.TryEncode(Header, still, bytes, out _));
        still = RestPose();
        still[0] = still[0] with { Position = new Vector3(0, float.NaN, 0) };
        Assert.False(CompactPose.TryEncode(Header, still, bytes, out _));
        Assert.False(CompactPose.TryEncode(new MotionFrame(new MotionHeader(), new float[17]), bytes, out _));
    }

    [Fact]
    public void Other_bytes_are_refused()
    {
        byte[] good = Encode(Header, RestPose());
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int length = 0; length < good.Length; length++)
            Assert.False(CompactPose.TryDecode(good.AsSpan(0, length), out _, pose));

        Assert.False(CompactPose.TryDecode([.. good, 0], out _, pose));
        (int Offset, byte[] Bytes)[] changes =
        [
            (0, [0]), (0, [2]), (1, [4]), (1, [0]), (2, [33]), (2, [5]), (3, [1]), (15, [0x7F]), (15, [0x80]), (20, [0, 0, 0x80, 0x7F]), (28, [0, 0, 0xC0, 0xFF]),
            (32, [0xFF, 0x7F, 0xFF, 0x7F, 0xFF, 0x7F]), (37, [0xC0]), (385, [0xFF]), (387, [0]),
        ];
        foreach ((int offset, byte[] bytes) in changes)
        {
            byte[] bad = (byte[])good.Clone();
            bytes.CopyTo(bad, offset);
            Assert.False(CompactPose.TryDecode(bad, out _, pose), $"{offset}: {Hex(bytes)}");
        }
    }

    [Fact]
    public void No_bytes_make_it_throw_or_give_a_pose_that_is_not_finite()
    {
        var random = new Random(11);
        byte[] good = Encode(Header, VectorPose());
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        int decoded = 0;
        for (int i = 0; i < 20_000; i++)
        {
            byte[] bytes = (byte[])good.Clone();
            for (int changes = random.Next(1, 4); changes > 0; changes--)
                bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
            if (!CompactPose.TryDecode(bytes, out _, pose))
                continue;

            decoded++;
            Assert.True(Array.TrueForAll(pose, static bone => Math.Abs(bone.Rotation.Length() - 1) < 1e-4f));
        }

        Assert.InRange(decoded, 1, 19_999);
    }

    [Fact]
    public void Too_little_room_is_the_callers_fault()
    {
        byte[] bytes = new byte[CompactPose.MaxSize];
        Assert.Throws<ArgumentException>(() => CompactPose.TryEncode(Header, RestPose(), bytes.AsSpan(1), out _));
        Assert.Throws<ArgumentException>(() => CompactPose.TryEncode(Header, RestPose().AsSpan(1), bytes, out _));
        Assert.Throws<ArgumentException>(() => CompactPose.TryDecode(bytes, out _, new BoneTransform[58]));
    }

    [Fact]
    public void Nothing_is_allocated()
    {
        var frame = new MotionFrame(new MotionHeader { FrameIndex = 1, AvatarName = new AvatarName("Ann") }, new float[354]);
        byte[] bytes = new byte[CompactPose.MaxSize];
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        Allocations.AssertNone(() =>
        {
            CompactPose.TryEncode(frame, bytes, out int length);
            CompactPose.TryDecode(bytes.AsSpan(0, length), out _, pose);
        });
    }

    private static byte[] Encode(in CompactPoseHeader header, BoneTransform[] pose)
    {
        byte[] bytes = new byte[CompactPose.MaxSize];
        Assert.True(CompactPose.TryEncode(header, pose, bytes, out int length));
        return bytes[..length];
    }

    private static BoneTransform[] RestPose(SkeletonVariant variant = SkeletonVariant.Neck1)
    {
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        SkeletonBody.GetDefault(variant).CopyRestPose(pose);
        return pose;
    }

    // Rotations of small whole numbers, far from the middle between two steps.
    private static BoneTransform[] VectorPose() =>
    [
        .. Enumerable.Range(0, BoneHierarchy.BoneCount).Select(static i => new BoneTransform(
            new Vector3(1, -2, 0.5f), new Quaternion((i * 7 % 11) - 5, (i * 6 % 7) - 3, (i * 3 % 5) - 2, (i * 12 % 13) - 6.5f))),
    ];

    // The decoder of docs/reference/compact-pose.md, in double precision.
    private static double[] DecodeAsOnPage(byte[] bytes, int bone)
    {
        ushort[] words = [.. Enumerable.Range(0, 3).Select(i => BinaryPrimitives.ReadUInt16LittleEndian(bytes.AsSpan(32 + (6 * bone) + (2 * i))))];
        int largest = (words[0] >> 15) + (2 * (words[1] >> 15));
        List<double> parts = [.. words.Select(static word => ((word & 0x7FFF) - 16384) / (16383 * Math.Sqrt(2)))];
        parts.Insert(largest, Math.Sqrt(1 - parts.Sum(static part => part * part)));
        return [.. parts];
    }

    private static double Degrees(Quaternion one, Quaternion other) => Degrees([one.X, one.Y, one.Z, one.W], other);

    // From the chord, because the cosine of a small angle does not determine it accurately.
    private static double Degrees(double[] one, Quaternion other)
    {
        double[] two = [other.X, other.Y, other.Z, other.W];
        double length = Math.Sqrt(one.Sum(static part => part * part));
        double sign = one.Zip(two, static (a, b) => a * b).Sum() < 0 ? -1 : 1;
        double chord = Math.Sqrt(one.Zip(two, (a, b) => ((a / length) - (sign * b)) * ((a / length) - (sign * b))).Sum());
        return 4 * Math.Asin(Math.Min(1, chord / 2)) * 180 / Math.PI;
    }

    private static string Hex(byte[] bytes) => Convert.ToHexString(bytes);
}
