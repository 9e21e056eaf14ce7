using System.Numerics;
using System.Text.Json;
using NeuronMocap.Skeleton;

namespace NeuronMocap.View.Tests.Infrastructure;

/// <summary>Compares joints of the page, in metres, with those of the library, in centimetres.</summary>
internal static class Joints
{
    public static Dictionary<string, Vector3> Read(JsonElement joints) => joints.EnumerateObject().ToDictionary(
        static joint => joint.Name,
        static joint => new Vector3(joint.Value[0].GetSingle(), joint.Value[1].GetSingle(), joint.Value[2].GetSingle()),
        StringComparer.Ordinal);

    /// <summary>The largest distance between the joints, in metres.</summary>
    public static float Distance(JsonElement joints, ReadOnlySpan<BoneTransform> world)
    {
        Dictionary<string, Vector3> found = Read(joints);
        Assert.Equal(BoneHierarchy.BoneCount, found.Count);
        float largest = 0;
        foreach (Bone bone in BoneHierarchy.Bones)
            largest = Math.Max(largest, Vector3.Distance(found[BoneHierarchy.GetName(bone)], world[(int)bone].Position / 100));

        return largest;
    }
}
