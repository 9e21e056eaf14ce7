using System.Globalization;
using System.Text;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Csv;

// The comment lines of a table and the row with the names of its columns.
internal static class PoseCsvHeader
{
    private static readonly string[] Components = ["x", "y", "z", "qx", "qy", "qz", "qw"];

    public static byte[] Create(PoseCsvOptions options)
    {
        var text = new StringBuilder();
        void Comment(string line) => text.Append("# ").Append(OneLine(line)).Append('\n');

        Comment("Poses of Neuron's 59 bones: a row for each frame of each avatar");
        if (options.Source is { } source)
            Comment($"source: {source}");
        if (options.StartTime is { } start)
            Comment($"start: {start.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss.fff'Z'", CultureInfo.InvariantCulture)}");
        if (options.FrameRate is { } rate)
            Comment(FormattableString.Invariant($"rate: {rate:0.######} frames per second"));
        if (options.RotationOrder is { } order)
            Comment($"rotation order of the source: {order}");

        Comment("time: seconds since the start");
        Comment("avatar: number of the avatar");
        foreach (KeyValuePair<int, string> avatar in options.AvatarNames)
            Comment(FormattableString.Invariant($"avatar {avatar.Key}: {avatar.Value}"));

        Comment("frame: number of the frame; empty if it has none");
        Comment("arrival: seconds since the start at which the frame was received; empty if it was not recorded");
        Comment($"_x _y _z: position of the joint in the world, in {(options.Unit == LengthUnit.Metres ? "metres" : "centimetres")}");
        Comment("_qx _qy _qz _qw: rotation of the bone in the world, a unit quaternion with its scalar last; the identity in T-pose");
        Comment(options.UpAxis == UpAxis.Z
            ? "axes: right-handed; x forward, y to the left, z up, for a performer in T-pose"
            : "axes: right-handed; x to the left, y up, z forward, for a performer in T-pose");
        Comment($"parents: {DescribeParents(options.Variant)}");

        text.Append("time,avatar,frame,arrival");
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            foreach (string component in Components)
                text.Append(',').Append(BoneHierarchy.GetName(bone, options.Variant)).Append('_').Append(component);
        }

        return Encoding.UTF8.GetBytes(text.Append('\n').ToString());
    }

    private static string DescribeParents(SkeletonVariant variant)
    {
        var pairs = new List<string>();
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            if (BoneHierarchy.GetParent(bone, variant) is { } parent)
                pairs.Add($"{BoneHierarchy.GetName(bone, variant)}={BoneHierarchy.GetName(parent, variant)}");
        }

        return string.Join(" ", pairs);
    }

    // Names of files and avatars are foreign text. A line end in them would begin a row.
    private static string OneLine(string text)
    {
        var line = new StringBuilder(text.Length);
        foreach (char character in text)
            line.Append(char.IsControl(character) || character is '\u2028' or '\u2029' ? ' ' : character);

        return line.ToString();
    }
}
