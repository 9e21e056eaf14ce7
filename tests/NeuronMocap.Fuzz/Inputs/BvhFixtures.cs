using System.Globalization;
using System.Text;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>BVH files with a few joints, with the 59 bones of both variants, and with features of real files.</summary>
internal static class BvhFixtures
{
    private const string TwoJoints =
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

    private const string Rows = "1 2 3 4 5 6 7 8 9 \n-1 -2.25 -3e-3 -0.000000 5 6 7 8 9\n";

    public static IReadOnlyList<byte[]> Words { get; } =
    [
        .. ((string[])[
            "HIERARCHY", "ROOT", "JOINT", "End Site", "OFFSET", "CHANNELS", "CHANNELS 6", "CHANNELS 2000000000", "MOTION", "Frames:", "Frame Time:",
            "{", "}", "{{{{", "}}}}", "Xposition", "Zrotation", " ", "\t", "\n", "\r\n", "\r", ":", "-", ".", "e", "\0", "\u00EF\u00BB\u00BF",
            "0", "1", "-1", "1e39", "1e-46", "-0.0", "nan", "-nan(ind)", "inf", "1.#QNAN", "1e999999999", "9007199254740993", "2147483647",
            "2147483648", "4294967296", "-6.27744e+66", "0.008", "16777217", "3.4028235677973366e38", "7.115569763501211648000000E+19",
        ]).Select(Encoding.Latin1.GetBytes),
    ];

    public static IReadOnlyList<byte[]> Create() =>
    [
        .. ((string[])[
            $"{TwoJoints}MOTION\n\nFrames: 2\nFrame Time: 0.008\n{Rows}",
            $"{TwoJoints}MOTION\r\nFrames: 2\r\nFrame Time: 0.017\r\n{Rows}MOTION\nFrames: -6.27744e+66\nFrame Time: nan\n{Rows}",
            TwoJoints,
            "HIERARCHY ROOT a { CHANNELS 1 Xrotation } MOTION Frames: 3 Frame Time: 0.0333333\n1\n2\n3",
            Neuron(SkeletonVariant.Neck1, displacement: false, rows: 2),
            Neuron(SkeletonVariant.Spine3, displacement: true, rows: 1),
        ]).Select(Encoding.UTF8.GetBytes),
    ];

    private static string Neuron(SkeletonVariant variant, bool displacement, int rows)
    {
        var text = new StringBuilder("HIERARCHY\n");
        WriteJoint(text, Bone.Hips, variant, displacement);
        text.Append(CultureInfo.InvariantCulture, $"MOTION\nFrames: {rows}\nFrame Time: 0.0083333\n");
        for (int row = 0; row < rows; row++)
            text.AppendJoin(' ', Enumerable.Range(0, displacement ? 354 : 180)).Append('\n');

        return text.ToString();
    }

    private static void WriteJoint(StringBuilder text, Bone bone, SkeletonVariant variant, bool displacement)
    {
        string keyword = bone == Bone.Hips ? "ROOT" : "JOINT";
        string channels = bone == Bone.Hips || displacement ? "6 Xposition Yposition Zposition" : "3";
        text.Append($"{keyword} {BoneHierarchy.GetName(bone, variant)}\n{{\nOFFSET 1 0.5 -1\nCHANNELS {channels} Yrotation Xrotation Zrotation\n");
        Bone[] children = [.. BoneHierarchy.Bones.ToArray().Where(child => BoneHierarchy.GetParent(child, variant) == bone)];
        foreach (Bone child in children)
            WriteJoint(text, child, variant, displacement);

        text.Append(children.Length == 0 ? "End Site\n{\nOFFSET 0 1 0\n}\n}\n" : "}\n");
    }
}
