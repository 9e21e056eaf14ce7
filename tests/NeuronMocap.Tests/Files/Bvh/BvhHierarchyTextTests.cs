using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Skeleton;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhHierarchyTextTests
{
    public static MatrixTheoryData<SkeletonVariant, RotationOrder, bool, bool> EveryFormat =>
        new(Enum.GetValues<SkeletonVariant>(), Enum.GetValues<RotationOrder>(), [false, true], [false, true]);

    [Theory, MemberData(nameof(EveryFormat))]
    public void Written_text_reads_back_as_the_same_skeleton(SkeletonVariant variant, RotationOrder order, bool displacement, bool reference)
    {
        var format = new SkeletonFormat(order, variant);
        var layout = new ChannelLayout(displacement, reference);
        BvhDocument document = Parse(BvhHierarchyText.Create(format, layout));

        Assert.Empty(document.Repairs);
        Assert.True(BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason), reason);
        Assert.Equal(format, map.Format);
        Assert.Equal(layout, map.Layout);
        Assert.Equal(layout.ValueCount, document.ChannelCount);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Assert.Equal(DefaultOffsets.Get(bone, variant), map[bone].Offset);
            Assert.Equal(DefaultOffsets.TryGetEndSite(bone, out Vector3 end) ? end : null, map[bone].EndSite);
            Assert.Equal(layout.GetRotationIndex(bone), map[bone].FirstChannel + map[bone].Channels.Count - 3);
        }
    }

    [Fact]
    public void The_default_text_matches_appendix_b()
    {
        Runtimes.SkipOnMono("writes a negative zero, which the table has, without its sign.");
        string text = BvhHierarchyText.Create(SkeletonFormat.Default, default);
        BvhDocument document = Parse(text);

        Assert.StartsWith(
            "HIERARCHY\r\nROOT Hips\r\n{\r\n    OFFSET 0.000 84.102 0.000\r\n"
            + "    CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\r\n    JOINT RightUpLeg\r\n    {\r\n"
            + "        OFFSET -9.500 -0.000 0.000\r\n        CHANNELS 3 Yrotation Xrotation Zrotation\r\n",
            text,
            StringComparison.Ordinal);
        Assert.Equal(
            ManualTables.AppendixB.Select(static row => FormattableString.Invariant($"OFFSET {row.X:F3} {row.Y:F3} {row.Z:F3}")).Order(StringComparer.Ordinal),
            OffsetsOfJoints(text).Order(StringComparer.Ordinal));
        Assert.EndsWith("OFFSET 1.598 0.000 0.000", text.TrimEnd('}', ' ', '\r', '\n'), StringComparison.Ordinal);
        Assert.Equal(
            ManualTables.AppendixB.Select(row => (row.Name, row.Parent, new Vector3(row.X, row.Y, row.Z))),
            document.Joints.Select(joint => (joint.Name, joint.Parent?.Name, joint.Offset)));
        Assert.Equal(
            ManualTables.EndSites.Select(row => (row.Name, new Vector3(row.X, row.Y, row.Z))).Order(Comparer<(string Name, Vector3)>.Create(
                (left, right) => string.CompareOrdinal(left.Name, right.Name))),
            document.Joints.Where(joint => joint.EndSite is not null).Select(joint => (joint.Name, joint.EndSite!.Value)).Order(
                Comparer<(string Name, Vector3)>.Create((left, right) => string.CompareOrdinal(left.Name, right.Name))));
    }

    private static IEnumerable<string> OffsetsOfJoints(string text)
    {
        string[] lines = [.. text.Split("\r\n").Select(static line => line.Trim())];
        return lines.Where((line, i) => line.StartsWith("OFFSET", StringComparison.Ordinal) && !lines[i - 2].StartsWith("End Site", StringComparison.Ordinal));
    }

    [Fact]
    public void A_body_of_any_lengths_keeps_them_bit_for_bit()
    {
        var random = new Random(4);
        Vector3[] offsets = new Vector3[59];
        Vector3[] ends = new Vector3[59];
        for (int round = 0; round < 50; round++)
        {
            for (int bone = 0; bone < 59; bone++)
            {
                offsets[bone] = new Vector3(AnyFloat(random), AnyFloat(random), AnyFloat(random));
                ends[bone] = new Vector3(AnyFloat(random), AnyFloat(random), AnyFloat(random));
            }

            BvhDocument document = Parse(BvhHierarchyText.Create(offsets, ends, SkeletonFormat.Default, default));
            foreach (BvhJoint joint in document.Joints)
            {
                AssertBits(offsets[joint.Index], joint.Offset);
                if (joint.EndSite is { } end)
                    AssertBits(ends[joint.Index], end);
            }
        }
    }

    [Fact]
    public void Wrong_arguments_are_refused()
    {
        Assert.Throws<ArgumentException>(() => BvhHierarchyText.Create(new Vector3[58], default, SkeletonFormat.Default, default));
        Assert.Throws<ArgumentException>(() => BvhHierarchyText.Create(new Vector3[59], new Vector3[1], SkeletonFormat.Default, default));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => BvhHierarchyText.Create(new SkeletonFormat((RotationOrder)6, SkeletonVariant.Neck1), default));
    }

    private static void AssertBits(Vector3 expected, Vector3 actual) =>
        BvhSamples.AssertBits([expected.X, expected.Y, expected.Z], [actual.X, actual.Y, actual.Z]);

    // Any bits, except for the many patterns of NaN, which text does not distinguish.
    private static float AnyFloat(Random random)
    {
        float value = BitConverter.Int32BitsToSingle(random.Next(int.MinValue, int.MaxValue));
        return random.Next(4) switch
        {
            0 when !float.IsNaN(value) => value,
            1 => 0 * (random.Next(2) - 0.5f),
            _ => (random.NextSingle() - 0.5f) * 200,
        };
    }
}
