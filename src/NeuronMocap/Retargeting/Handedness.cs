using System.Numerics;

namespace NeuronMocap.Retargeting;

// The effect of negative scales above a node on its rotation: they mirror its axis. Unity's Transform.rotation does the same.
internal static class Handedness
{
    // The factors for the axis of a rotation, from the product of the scales above it. The signs mirror the axis, and their product mirrors it once
    // more.
    public static Vector3 FromScale(Vector3 scale)
    {
        var signs = new Vector3(Sign(scale.X), Sign(scale.Y), Sign(scale.Z));
        return signs * (signs.X * signs.Y * signs.Z);
    }

    // This operation is its own inverse.
    public static Quaternion Apply(Vector3 handedness, Quaternion rotation) =>
        new(rotation.X * handedness.X, rotation.Y * handedness.Y, rotation.Z * handedness.Z, rotation.W);

    private static float Sign(float value) => value < 0 ? -1 : 1;
}
