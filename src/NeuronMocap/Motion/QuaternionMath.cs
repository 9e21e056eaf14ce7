using System.Numerics;

namespace NeuronMocap.Motion;

// What System.Numerics lacks about quaternions. A rotation has two, q and -q; all here take the shorter way.
internal static class QuaternionMath
{
    // The turn that leads from one rotation to another: its axis in the axes of both, its length in radians, at most pi.
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

    // Goes on past either end at the same speed.
    public static Quaternion Slerp(Quaternion from, Quaternion to, float part)
    {
        to = InHemisphereOf(from, to);
        float cosine = Quaternion.Dot(from, to);
        float sine = Difference(from, to).Length() / 2;

        // From the chord: near 1 a cosine says nothing about the angle.
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
