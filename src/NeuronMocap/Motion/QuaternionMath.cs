using System.Numerics;

namespace NeuronMocap.Motion;

// Quaternion functions that System.Numerics lacks. A rotation has two quaternions, q and -q; all functions here take the shorter rotation.
internal static class QuaternionMath
{
    // The rotation vector from one rotation to another. Its direction is the axis, which is the same in the axes of both. Its length is the angle
    // in radians, at most pi.
    public static Vector3 TurnBetween(Quaternion from, Quaternion to)
    {
        Quaternion turn = to * Quaternion.Conjugate(from);
        var axis = new Vector3(turn.X, turn.Y, turn.Z);
        float sine = axis.Length();
        if (sine == 0)
            return Vector3.Zero;

        float sign = turn.W < 0 ? -1 : 1;
        return axis * (sign * 2 * MathF.Atan2(sine, sign * turn.W) / sine);
    }

    public static Quaternion InHemisphereOf(Quaternion reference, Quaternion rotation) =>
        Quaternion.Dot(reference, rotation) < 0 ? Quaternion.Negate(rotation) : rotation;

    // Extrapolates beyond either end at the same speed.
    public static Quaternion Slerp(Quaternion from, Quaternion to, float part)
    {
        to = InHemisphereOf(from, to);
        float cosine = Quaternion.Dot(from, to);
        float sine = Difference(from, to).Length() / 2;

        // The angle comes from the chord, because a cosine near 1 does not determine the angle accurately.
        float half = MathF.Asin(Math.Min(sine, 1));
        if (half < 1e-4f || cosine >= 1)
            return Quaternion.Normalize(Quaternion.Lerp(from, to, part));

        float angle = 2 * half;
        float whole = MathF.Sin(angle);
        return Quaternion.Normalize((from * (MathF.Sin((1 - part) * angle) / whole)) + (to * (MathF.Sin(part * angle) / whole)));
    }

    private static Vector4 Difference(Quaternion one, Quaternion other) =>
        new(one.X - other.X, one.Y - other.Y, one.Z - other.Z, one.W - other.W);
}
