using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Server.Sources;

// Writes BVH files of the 59 bones in the default body: rotation channels Y X Z, positions only for the hips.
internal static class NeuronTake
{
    public static byte[] Write(int rows) => Write(rows, static (row, bone) => new Vector3(row * 7 % 50, (int)bone % 40, row - (int)bone));

    public static byte[] Write(int rows, Func<int, Bone, Vector3> angles)
    {
        var text = new StringBuilder("HIERARCHY\n");
        WriteJoint(text, Bone.Hips);
        text.Append(CultureInfo.InvariantCulture, $"MOTION\nFrames: {rows}\nFrame Time: 0.016667\n");
        for (int row = 0; row < rows; row++)
        {
            text.Append("0 84.102 0");
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                Vector3 angle = angles(row, bone);
                text.Append(CultureInfo.InvariantCulture, $" {angle.X} {angle.Y} {angle.Z}");
            }

            text.Append('\n');
        }

        return Encoding.ASCII.GetBytes(text.ToString());
    }

    private static void WriteJoint(StringBuilder text, Bone bone)
    {
        Vector3 offset = DefaultOffsets.Get(bone);
        string positions = bone == Bone.Hips ? "6 Xposition Yposition Zposition" : "3";
        text.Append(
            CultureInfo.InvariantCulture,
            $"{(bone == Bone.Hips ? "ROOT" : "JOINT")} {BoneHierarchy.GetName(bone)}\n{{\nOFFSET {offset.X} {offset.Y} {offset.Z}\n");
        text.Append(CultureInfo.InvariantCulture, $"CHANNELS {positions} Yrotation Xrotation Zrotation\n");
        foreach (Bone child in BoneHierarchy.Bones)
        {
            if (BoneHierarchy.GetParent(child) == bone)
                WriteJoint(text, child);
        }

        if (DefaultOffsets.TryGetEndSite(bone, out Vector3 end))
            text.Append(CultureInfo.InvariantCulture, $"End Site\n{{\nOFFSET {end.X} {end.Y} {end.Z}\n}}\n");

        text.Append("}\n");
    }
}
