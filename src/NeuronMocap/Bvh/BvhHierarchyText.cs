using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>
/// The text that a BVH file begins with: the hierarchy of the 59 bones, laid out as in the manual's Appendix B and in Axis Neuron's files. Numbers
/// have three decimals, and more where three would change them: <see cref="BvhDocument.Parse"/> reads the very same values.
/// </summary>
public static class BvhHierarchyText
{
    // What Axis Neuron's files have.
    private const string LineEnd = "\r\n";
    private const int Indentation = 4;
    private const string PositionChannels = "Xposition Yposition Zposition ";

    /// <summary>Writes the hierarchy of the default body, that of Appendix B: <see cref="DefaultOffsets"/>.</summary>
    /// <param name="format">Names of the bones, and order of the rotation channels.</param>
    /// <param name="layout">
    /// Which channels there are: six for every bone with displacement, else six for the hips and three for the others. With a reference, a root of
    /// that name with six channels, at the origin, carries the hips.
    /// </param>
    /// <returns>The text from HIERARCHY to the last brace, with CR LF at the end of each line; ASCII.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such rotation order.</exception>
    public static string Create(SkeletonFormat format, ChannelLayout layout)
    {
        Span<Vector3> offsets = stackalloc Vector3[BoneHierarchy.BoneCount];
        for (int bone = 0; bone < offsets.Length; bone++)
            offsets[bone] = DefaultOffsets.Get((Bone)bone, format.Variant);

        return Create(offsets, default, format, layout);
    }

    /// <summary>Writes the hierarchy of a body.</summary>
    /// <param name="offsets">The bones' places relative to their parents, 59 in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="endSites">
    /// Where the bones end that have no children, relative to them, 59 in <see cref="Bone"/> order; those of other bones have no meaning. Empty:
    /// the default body's, <see cref="DefaultOffsets.TryGetEndSite"/>.
    /// </param>
    /// <param name="format">Names of the bones, and order of the rotation channels.</param>
    /// <param name="layout">Which channels there are; see the other overload.</param>
    /// <returns>The text from HIERARCHY to the last brace, with CR LF at the end of each line; ASCII.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 offsets, or End Sites but fewer than 59.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such rotation order.</exception>
    public static string Create(ReadOnlySpan<Vector3> offsets, ReadOnlySpan<Vector3> endSites, SkeletonFormat format, ChannelLayout layout)
    {
        if (offsets.Length < BoneHierarchy.BoneCount)
            throw new ArgumentException("There is an offset for each of the 59 bones.", nameof(offsets));
        if (endSites.Length is > 0 and < BoneHierarchy.BoneCount)
            throw new ArgumentException("There is an End Site for each of the 59 bones, or none at all.", nameof(endSites));

        var writer = new Writer(offsets, endSites, format, layout);
        return writer.Write();
    }

    private static string RotationChannels(RotationOrder order) => order switch
    {
        RotationOrder.XZY => "Xrotation Zrotation Yrotation",
        RotationOrder.YXZ => "Yrotation Xrotation Zrotation",
        RotationOrder.XYZ => "Xrotation Yrotation Zrotation",
        RotationOrder.YZX => "Yrotation Zrotation Xrotation",
        RotationOrder.ZXY => "Zrotation Xrotation Yrotation",
        RotationOrder.ZYX => "Zrotation Yrotation Xrotation",
        _ => throw new ArgumentOutOfRangeException(nameof(order), order, "There are six rotation orders, 0 to 5."),
    };

    private readonly ref struct Writer(
        ReadOnlySpan<Vector3> offsets,
        ReadOnlySpan<Vector3> endSites,
        SkeletonFormat format,
        ChannelLayout layout)
    {
        private readonly ReadOnlySpan<Vector3> _offsets = offsets;
        private readonly ReadOnlySpan<Vector3> _endSites = endSites;
        private readonly StringBuilder _text = new();
        private readonly string _threeChannels = "3 " + RotationChannels(format.RotationOrder);
        private readonly string _sixChannels = "6 " + PositionChannels + RotationChannels(format.RotationOrder);

        public string Write()
        {
            Line(0, "HIERARCHY");
            if (!layout.HasReference)
            {
                WriteBone(Bone.Hips, "ROOT", depth: 0);
                return _text.ToString();
            }

            Open(0, "ROOT " + BvhSkeletonMap.ReferenceName);
            WriteOffset(1, Vector3.Zero);
            Line(1, "CHANNELS " + _sixChannels);
            WriteBone(Bone.Hips, "JOINT", depth: 1);
            Line(0, "}");
            return _text.ToString();
        }

        private void WriteBone(Bone bone, string kind, int depth)
        {
            Open(depth, $"{kind} {BoneHierarchy.GetName(bone, format.Variant)}");
            WriteOffset(depth + 1, _offsets[(int)bone]);
            Line(depth + 1, "CHANNELS " + (layout.PositionIndex(bone) >= 0 ? _sixChannels : _threeChannels));
            for (Bone child = bone + 1; (int)child < BoneHierarchy.BoneCount; child++)
            {
                if (BoneHierarchy.GetParent(child, format.Variant) == bone)
                    WriteBone(child, "JOINT", depth + 1);
            }

            if (DefaultOffsets.TryGetEndSite(bone, out Vector3 end))
                WriteEndSite(depth + 1, _endSites.IsEmpty ? end : _endSites[(int)bone]);

            Line(depth, "}");
        }

        private void WriteEndSite(int depth, Vector3 end)
        {
            Open(depth, "End Site");
            WriteOffset(depth + 1, end);
            Line(depth, "}");
        }

        private void WriteOffset(int depth, Vector3 offset) =>
            Line(depth, $"OFFSET {Number(offset.X)} {Number(offset.Y)} {Number(offset.Z)}");

        private void Open(int depth, string line)
        {
            Line(depth, line);
            Line(depth, "{");
        }

        private void Line(int depth, string line) => _text.Append(' ', depth * Indentation).Append(line).Append(LineEnd);

        // The shortest digits that are read back as the same value; a decimal holds all of them and never writes an exponent.
        private static string Number(float value)
        {
            const float LargestWithoutExponent = 1e15f;
            const float SmallestWithoutExponent = 1e-15f;
            string shortest = value.ToString("R", CultureInfo.InvariantCulture);
            float magnitude = MathF.Abs(value);
            if (value == 0)
                return float.IsNegative(value) ? "-0.000" : "0.000";
            if (!(magnitude is > SmallestWithoutExponent and < LargestWithoutExponent))
                return shortest;

            decimal digits = decimal.Parse(shortest, NumberStyles.Float, CultureInfo.InvariantCulture);
            return digits.ToString("0.000#########################", CultureInfo.InvariantCulture);
        }
    }
}
