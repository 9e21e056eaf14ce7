using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Bvh;

internal static class BvhSamples
{
    public const string Hierarchy =
        """
        HIERARCHY
        ROOT Hips
        {
            OFFSET 0.000 93.020 -0.000
            CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation
            JOINT Spine
            {
                OFFSET 0.5 14.307 1e-1
                CHANNELS 3 Yrotation Xrotation Zrotation
                End Site
                {
                    OFFSET 0 15.95 -2
                }
            }
        }

        """;

    /// <summary>Two joints, nine channels, two rows. There is a blank line after MOTION and a space after each row, as Axis Neuron writes.</summary>
    public const string TwoRows =
        Hierarchy + "MOTION\n\nFrames: 2\nFrame Time: 0.008\n1 2 3 4 5 6 7 8 9 \n-1 -2 -3 -4 -5 -6 -7 -8 -9 \n";

    public const string Row = "1 2 3 4 5 6 7 8 9\n";

    public static BvhDocument Parse(string text) => BvhDocument.Parse(Encoding.UTF8.GetBytes(text));

    /// <summary>Reads the hierarchy of two joints with the given lines below "Frame Time: 0.008".</summary>
    public static BvhDocument ParseRows(int frames, string rows) =>
        Parse($"{Hierarchy}MOTION\nFrames: {frames}\nFrame Time: 0.008\n{rows}");

    public static float[] Values(BvhDocument document) =>
        [.. Enumerable.Range(0, document.FrameCount).SelectMany(frame => document.GetValues(frame).ToArray())];

    public static BvhRepair OnlyRepair(BvhDocument document)
    {
        Assert.Equal(document.RepairCount, document.Repairs.Count);
        return Assert.Single(document.Repairs);
    }

    public static string NamesOf(BvhDocument document) => string.Join(' ', document.Joints.Select(joint => joint.Name));

    public static void AssertBits(ReadOnlySpan<float> expected, ReadOnlySpan<float> actual)
    {
        Assert.Equal(expected.Length, actual.Length);
        for (int i = 0; i < expected.Length; i++)
        {
            if (BitConverter.SingleToInt32Bits(expected[i]) != BitConverter.SingleToInt32Bits(actual[i]))
                Assert.Fail($"Value {i} is {actual[i]:R} instead of {expected[i]:R}.");
        }
    }

    public static void AssertSame(BvhDocument expected, BvhDocument actual)
    {
        Assert.Equal(Describe(expected), Describe(actual));
        Assert.Equal(expected.ChannelCount, actual.ChannelCount);
        Assert.Equal(expected.DeclaredFrameTime, actual.DeclaredFrameTime);
        Assert.Equal(expected.FrameRate, actual.FrameRate);
        Assert.Equal(expected.Repairs, actual.Repairs);
        AssertBits(Values(expected), Values(actual));
    }

    /// <summary>A file of the 59 bones, with one row whose values are their own index.</summary>
    public static string Neuron(
        SkeletonVariant variant = SkeletonVariant.Neck1,
        bool displacement = false,
        string rotations = "Yrotation Xrotation Zrotation",
        Func<Bone, string, string>? edit = null)
    {
        var text = new StringBuilder("HIERARCHY\n");
        WriteJoint(text, Bone.Hips, variant, displacement, rotations, edit ?? ((_, joint) => joint));
        int count = displacement ? 354 : 180;
        return text.Append("MOTION\nFrames: 1\nFrame Time: 0.017\n").AppendJoin(' ', Enumerable.Range(0, count)).Append('\n').ToString();
    }

    /// <summary>A file of the 59 bones below another root. The root's own values are negative, so the others keep their index.</summary>
    public static string UnderRoot(string name, string channels, SkeletonVariant variant = SkeletonVariant.Neck1, bool displacement = false)
    {
        int count = channels[0] - '0';
        return Neuron(variant, displacement)
            .Replace("ROOT Hips", $"ROOT {name}\n{{\nOFFSET 0 0 0\nCHANNELS {channels}\nJOINT Hips", StringComparison.Ordinal)
            .Replace("MOTION", "}\nMOTION", StringComparison.Ordinal)
            .Replace("0.017\n", $"0.017\n{string.Join(' ', Enumerable.Range(0, count).Select(i => $"-{count - i}"))} ", StringComparison.Ordinal);
    }

    /// <summary>Puts a prefix before the names of all joints.</summary>
    public static string WithPrefix(string text, string prefix) =>
        text.Replace("ROOT ", "ROOT " + prefix, StringComparison.Ordinal).Replace("JOINT ", "JOINT " + prefix, StringComparison.Ordinal);

    private static void WriteJoint(
        StringBuilder text,
        Bone bone,
        SkeletonVariant variant,
        bool displacement,
        string rotations,
        Func<Bone, string, string> edit)
    {
        string channels = bone == Bone.Hips || displacement ? $"6 Xposition Yposition Zposition {rotations}" : $"3 {rotations}";
        string name = BoneHierarchy.GetName(bone, variant);
        text.Append(edit(bone, $"{(bone == Bone.Hips ? "ROOT" : "JOINT")} {name}\n{{\nOFFSET {(int)bone} 0.5 -1\nCHANNELS {channels}\n"));
        Bone[] children = [.. BoneHierarchy.Bones.ToArray().Where(child => BoneHierarchy.GetParent(child, variant) == bone)];
        foreach (Bone child in children)
            WriteJoint(text, child, variant, displacement, rotations, edit);

        text.Append(children.Length == 0 ? "End Site\n{\nOFFSET 0 1 0\n}\n}\n" : "}\n");
    }

    private static string Describe(BvhDocument document) => string.Join('\n', document.Joints.Select(Describe));

    private static string Describe(BvhJoint joint) =>
        $"{joint.Index} {joint.Name} < {joint.Parent?.Index} at {joint.Offset} to {joint.EndSite}: "
        + $"{joint.FirstChannel} {string.Join(' ', joint.Channels)}";
}
