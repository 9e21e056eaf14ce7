using System.Numerics;

namespace NeuronMocap.Retargeting;

// What negative scales above a node do to its rotation: they mirror its axis. Unity's Transform.rotation counts them in the same way.
internal static class Handedness
{
    // For the axis of a rotation, from the product of the scales above it: an axis is mirrored by the signs and once more by their product.
    public static Vector3 FromScale(Vector3 scale)
    {
        var signs = new Vector3(Sign(scale.X), Sign(scale.Y), Sign(scale.Z));
        return signs * (signs.X * signs.Y * signs.Z);
    }

    // Its own inverse.
    public static Quaternion Apply(Vector3 handedness, Quaternion rotation) =>
        new(rotation.X * handedness.X, rotation.Y * handedness.Y, rotation.Z * handedness.Z, rotation.W);

    private static float Sign(float value) => value < 0 ? -1 : 1;
}
