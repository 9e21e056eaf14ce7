using System.Numerics;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>
/// Creates the text that begins a BVH file, from HIERARCHY to the last brace.
/// </summary>
/// <remarks>
/// Numbers have as many decimals as the layout specifies, three in that of Axis Neuron. A number has more decimals if it would otherwise change:
/// <see cref="BvhDocument.Parse"/> reads exactly the same values.
/// </remarks>
public static class BvhHierarchyText
{
    /// <summary>Creates the text of the default body, that of the manual's Appendix B: <see cref="DefaultOffsets"/>.</summary>
    /// <param name="format">The names of the bones and the order of the rotation channels.</param>
    /// <param name="layout">The channels: see <see cref="BvhBoneHierarchy.Create(SkeletonFormat, ChannelLayout, SkeletonBody)"/>.</param>
    /// <returns>The text from HIERARCHY to the last brace; ASCII, with CR LF at the end of each line.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static string Create(SkeletonFormat format, ChannelLayout layout) => Create(BvhBoneHierarchy.Create(format, layout));

    /// <summary>Creates the text of a body.</summary>
    /// <param name="offsets">The positions of the 59 bones relative to their parents, in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="endSites">
    /// The ends of the bones that have no children, relative to the bones. There are 59 values in <see cref="Bone"/> order; those of other bones
    /// have no meaning. If empty, those of the default body: <see cref="DefaultOffsets.TryGetEndSite"/>.
    /// </param>
    /// <param name="format">The names of the bones and the order of the rotation channels.</param>
    /// <param name="layout">The channels; see the other overload.</param>
    /// <returns>The text from HIERARCHY to the last brace; ASCII, with CR LF at the end of each line.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 offsets, or there are End Sites but fewer than 59.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static string Create(ReadOnlySpan<Vector3> offsets, ReadOnlySpan<Vector3> endSites, SkeletonFormat format, ChannelLayout layout) =>
        Create(BvhBoneHierarchy.Create(format, layout, new SkeletonBody(offsets, endSites, format.Variant)));

    /// <summary>Creates the text of any hierarchy.</summary>
    /// <param name="hierarchy">The joints.</param>
    /// <param name="format">The text layout; null for <see cref="BvhTextFormat.AxisNeuron"/>.</param>
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

        // Without recursion, because a file may nest deeply. The joints are in the order of the file.
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
