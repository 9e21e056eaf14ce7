using System.Numerics;

namespace NeuronMocap.Calculation;

// Creates rotations from two directions. One is met exactly, the other as closely as possible.
internal static class AxisPair
{
    /// <summary>Creates the rotation that turns X into a direction, and Y as close as possible to another one.</summary>
    public static Quaternion FromX(Vector3 x, Vector3 nearY)
    {
        x = Unit(x, Vector3.UnitX);
        Vector3 y = Upright(nearY, x);
        return FromAxes(x, y, Vector3.Cross(x, y));
    }

    /// <summary>Creates the rotation that turns Y into a direction, and X as close as possible to another one.</summary>
    public static Quaternion FromY(Vector3 y, Vector3 nearX)
    {
        y = Unit(y, Vector3.UnitY);
        Vector3 x = Upright(nearX, y);
        return FromAxes(x, y, Vector3.Cross(x, y));
    }

    /// <summary>Finds the shortest rotation from one direction to another. If one of them has no length, this is the identity.</summary>
    public static Quaternion Between(Vector3 from, Vector3 to)
    {
        float product = from.Length() * to.Length();
        float w = product + Vector3.Dot(from, to);
        return w > 1e-6f * product ? Quaternion.Normalize(new Quaternion(Vector3.Cross(from, to), w)) : Quaternion.Identity;
    }

    private static Quaternion FromAxes(Vector3 x, Vector3 y, Vector3 z) => Quaternion.CreateFromRotationMatrix(
        new Matrix4x4(x.X, x.Y, x.Z, 0, y.X, y.Y, y.Z, 0, z.X, z.Y, z.Z, 0, 0, 0, 0, 1));

    private static Vector3 Upright(Vector3 near, Vector3 axis)
    {
        Vector3 rest = near - (Vector3.Dot(near, axis) * axis);
        if (rest.LengthSquared() > 1e-6f * near.LengthSquared())
            return Vector3.Normalize(rest);

        // Both directions are the same. Any perpendicular direction is valid.
        Vector3 other = MathF.Abs(axis.X) < 0.8f ? Vector3.UnitX : Vector3.UnitZ;
        return Vector3.Normalize(other - (Vector3.Dot(other, axis) * axis));
    }

    private static Vector3 Unit(Vector3 direction, Vector3 otherwise) =>
        direction.LengthSquared() > 1e-12f ? Vector3.Normalize(direction) : otherwise;
}
