using System.Numerics;

namespace NeuronMocap.Server.Sources.Synthetic;

// Rotations about one axis, in degrees; right-handed axes, Y up, X to the subject's left, Z forward.
internal static class Turn
{
    private const float RadiansPerHalfDegree = MathF.PI / 360;

    public static Quaternion X(float degrees)
    {
        float half = degrees * RadiansPerHalfDegree;
        return new Quaternion(MathF.Sin(half), 0, 0, MathF.Cos(half));
    }

    public static Quaternion Y(float degrees)
    {
        float half = degrees * RadiansPerHalfDegree;
        return new Quaternion(0, MathF.Sin(half), 0, MathF.Cos(half));
    }

    public static Quaternion Z(float degrees)
    {
        float half = degrees * RadiansPerHalfDegree;
        return new Quaternion(0, 0, MathF.Sin(half), MathF.Cos(half));
    }

    // Mirrors a rotation to the other side of the body.
    public static Quaternion Mirror(Quaternion rotation) => new(rotation.X, -rotation.Y, -rotation.Z, rotation.W);
}
