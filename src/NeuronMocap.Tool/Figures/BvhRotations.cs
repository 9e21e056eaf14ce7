using System.Numerics;
using NeuronMocap.Bvh;

namespace NeuronMocap.Tool.Figures;

/// <summary>Rotations of joints with channels in any number and order, as in any BVH file.</summary>
internal static class BvhRotations
{
    /// <summary>Gets the rotation of a joint relative to its parent.</summary>
    public static Quaternion Get(BvhJoint joint, ReadOnlySpan<float> row)
    {
        Quaternion rotation = Quaternion.Identity;
        for (int i = 0; i < joint.Channels.Count; i++)
        {
            if (AxisOf(joint.Channels[i]) is { } axis)
                rotation *= Quaternion.CreateFromAxisAngle(axis, row[joint.FirstChannel + i] * (MathF.PI / 180));
        }

        return rotation;
    }

    /// <summary>Gets the largest difference between the angles of a joint in two rows, in degrees.</summary>
    public static float LargestDifference(BvhJoint joint, ReadOnlySpan<float> before, ReadOnlySpan<float> row)
    {
        float largest = 0;
        for (int i = 0; i < joint.Channels.Count; i++)
        {
            if (AxisOf(joint.Channels[i]) is not null)
                largest = Math.Max(largest, MathF.Abs(row[joint.FirstChannel + i] - before[joint.FirstChannel + i]));
        }

        return largest;
    }

    private static Vector3? AxisOf(BvhChannel channel) => channel switch
    {
        BvhChannel.Xrotation => Vector3.UnitX,
        BvhChannel.Yrotation => Vector3.UnitY,
        BvhChannel.Zrotation => Vector3.UnitZ,
        _ => null,
    };
}
