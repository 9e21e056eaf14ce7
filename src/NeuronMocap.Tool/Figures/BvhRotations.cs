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
        IReadOnlyList<BvhChannel> channels = joint.Channels;
        for (int i = 0; i < channels.Count; i++)
        {
            BvhChannel channel = channels[i];
            if (!IsRotation(channel))
                continue;

            (float sine, float cosine) = MathF.SinCos(row[joint.FirstChannel + i] * (MathF.PI / 360));
            rotation *= channel switch
            {
                BvhChannel.Xrotation => new Quaternion(sine, 0, 0, cosine),
                BvhChannel.Yrotation => new Quaternion(0, sine, 0, cosine),
                _ => new Quaternion(0, 0, sine, cosine),
            };
        }

        return rotation;
    }

    /// <summary>Gets the largest difference between the angles of a joint in two rows, in degrees.</summary>
    public static float LargestDifference(BvhJoint joint, ReadOnlySpan<float> before, ReadOnlySpan<float> row)
    {
        float largest = 0;
        IReadOnlyList<BvhChannel> channels = joint.Channels;
        for (int i = 0; i < channels.Count; i++)
        {
            if (IsRotation(channels[i]))
                largest = Math.Max(largest, MathF.Abs(row[joint.FirstChannel + i] - before[joint.FirstChannel + i]));
        }

        return largest;
    }

    private static bool IsRotation(BvhChannel channel) => channel is BvhChannel.Xrotation or BvhChannel.Yrotation or BvhChannel.Zrotation;
}
