using System.Numerics;

namespace NeuronMocap.Bvh;

// A position in double precision, in the file's unit of length.
internal readonly record struct BvhPoint(double X, double Y, double Z)
{
    public double Length => Math.Sqrt((X * X) + (Y * Y) + (Z * Z));

    public static implicit operator BvhPoint(Vector3 vector) => new(vector.X, vector.Y, vector.Z);

    public static BvhPoint operator +(BvhPoint a, BvhPoint b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static BvhPoint operator -(BvhPoint a, BvhPoint b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public Vector3 ToVector() => new((float)X, (float)Y, (float)Z);
}
