using System.Numerics;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>
/// The text that a BVH file begins with. Numbers have as many decimals as the layout says, three in Axis Neuron's, and more where these would change
/// them: <see cref="BvhDocument.Parse"/> reads the very same values.
/// </summary>
public static class BvhHierarchyText
{
    /// <summary>Writes the hierarchy of the default body, that of the manual's Appendix B: <see cref="DefaultOffsets"/>.</summary>
    /// <param name="format">Names of the bones, and order of the rotation channels.</param>
    /// <param name="layout">Which channels there are: see <see cref="BvhBoneHierarchy.Create(SkeletonFormat, ChannelLayout, SkeletonBody)"/>.</param>
    /// <returns>The text from HIERARCHY to the last brace, with CR LF at the end of each line; ASCII.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such rotation order.</exception>
    public static string Create(SkeletonFormat format, ChannelLayout layout) => Create(BvhBoneHierarchy.Create(format, layout));

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
    public static string Create(ReadOnlySpan<Vector3> offsets, ReadOnlySpan<Vector3> endSites, SkeletonFormat format, ChannelLayout layout) =>
        Create(BvhBoneHierarchy.Create(format, layout, new SkeletonBody(offsets, endSites, format.Variant)));

    /// <summary>Writes any hierarchy.</summary>
    /// <param name="hierarchy">The joints.</param>
    /// <param name="format">How the text is laid out; null for <see cref="BvhTextFormat.AxisNeuron"/>.</param>
    /// <returns>The text from HIERARCHY to the last brace and its line end.</returns>
    public static string Create(BvhHierarchy hierarchy, BvhTextFormat? format = null)
    {
        ArgumentNullException.ThrowIfNull(hierarchy);
        return new Writer(format ?? BvhTextFormat.AxisNeuron).Write(hierarchy.Joints);
    }

    private sealed class Writer(BvhTextFormat format)
    {
        private readonly StringBuilder _text = new();
        private readonly Stack<BvhJoint> _open = new();

        // Without recursion: a file may nest deeply. The joints are in the order of the file.
        public string Write(IReadOnlyList<BvhJoint> joints)
        {
            Line("HIERARCHY");
            foreach (BvhJoint joint in joints)
            {
                CloseUpTo(joint.Parent);
                Open($"{(joint.Parent is null ? "ROOT" : "JOINT")} {joint.Name}".TrimEnd());
                _open.Push(joint);
                WriteOffset(joint.Offset);
                Line($"CHANNELS {string.Join(' ', joint.Channels.Select(static channel => channel.ToString()).Prepend($"{joint.Channels.Count}"))}");
            }

            CloseUpTo(null);
            return _text.ToString();
        }

        private void CloseUpTo(BvhJoint? parent)
        {
            while (_open.Count > 0 && _open.Peek() != parent)
            {
                if (_open.Peek().EndSite is { } end)
                    WriteEndSite(end);

                _open.Pop();
                Line("}");
            }
        }

        private void WriteEndSite(Vector3 end)
        {
            Open("End Site");
            Indent(_open.Count + 1);
            Append(end);
            Line("}");
        }

        private void WriteOffset(Vector3 offset)
        {
            Indent(_open.Count);
            Append(offset);
        }

        private void Append(Vector3 offset)
        {
            _text.Append("OFFSET");
            Append(offset.X);
            Append(offset.Y);
            Append(offset.Z);
            _text.Append(format.LineEnd);
        }

        private void Append(float value)
        {
            Span<byte> digits = stackalloc byte[TextDigits.MaxSize];
            digits = digits[..TextDigits.Write(digits, value, Math.Min(format.OffsetDecimals, TextDigits.MaxDecimals))];
            _text.Append(' ').Append(Encoding.ASCII.GetString(digits));
        }

        private void Open(string line)
        {
            Line(line);
            Line("{");
        }

        private void Line(string line)
        {
            Indent(_open.Count);
            _text.Append(line).Append(format.LineEnd);
        }

        private void Indent(int depth)
        {
            for (int i = 0; i < depth; i++)
                _text.Append(format.Indentation);
        }
    }
}
