namespace NeuronMocap.Bvh;

// A rotation as a unit quaternion in double precision. With float, converting a chain of twenty joints there and back would move a fingertip
// visibly.
internal readonly record struct BvhRotation(double X, double Y, double Z, double W)
{
    private const double RadiansPerHalfDegree = Math.PI / 360;

    // Above this cosine, the sine of the angle is too small as a divisor, and linear interpolation is exact enough.
    private const double Near = 1 - 1e-9;

    public static BvhRotation Identity => new(0, 0, 0, 1);

    public BvhRotation Inverse => new(-X, -Y, -Z, W);

    /// <summary>The rotation about the vertical in degrees: the twist about Y, regardless of the rest of the rotation.</summary>
    public double Heading => 2 * Math.Atan2(Y, W) * (180 / Math.PI);

    public static BvhRotation operator *(BvhRotation a, BvhRotation b) => new(
        (a.W * b.X) + (a.X * b.W) + (a.Y * b.Z) - (a.Z * b.Y),
        (a.W * b.Y) - (a.X * b.Z) + (a.Y * b.W) + (a.Z * b.X),
        (a.W * b.Z) + (a.X * b.Y) - (a.Y * b.X) + (a.Z * b.W),
        (a.W * b.W) - (a.X * b.X) - (a.Y * b.Y) - (a.Z * b.Z));

    /// <summary>Creates a rotation about one axis: 0 for X, 1 for Y, 2 for Z.</summary>
    public static BvhRotation About(int axis, double degrees)
    {
        double sine = Math.Sin(degrees * RadiansPerHalfDegree);
        double cosine = Math.Cos(degrees * RadiansPerHalfDegree);
        return new BvhRotation(axis == 0 ? sine : 0, axis == 1 ? sine : 0, axis == 2 ? sine : 0, cosine);
    }

    /// <summary>Interpolates along the shorter path from one rotation to another. A part of 0 gives the first, 1 the second.</summary>
    public static BvhRotation Slerp(BvhRotation from, BvhRotation to, double part)
    {
        double cosine = (from.X * to.X) + (from.Y * to.Y) + (from.Z * to.Z) + (from.W * to.W);
        double sign = cosine < 0 ? -1 : 1;
        double angle = Math.Acos(Math.Min(1, Math.Abs(cosine)));
        bool isNear = Math.Abs(cosine) > Near;
        double a = isNear ? 1 - part : Math.Sin((1 - part) * angle) / Math.Sin(angle);
        double b = sign * (isNear ? part : Math.Sin(part * angle) / Math.Sin(angle));
        return new BvhRotation(
            (a * from.X) + (b * to.X), (a * from.Y) + (b * to.Y), (a * from.Z) + (b * to.Z), (a * from.W) + (b * to.W)).Normalized();
    }

    public BvhPoint Turn(BvhPoint point)
    {
        BvhRotation turned = this * new BvhRotation(point.X, point.Y, point.Z, 0) * Inverse;
        return new BvhPoint(turned.X, turned.Y, turned.Z);
    }

    /// <summary>Gets an entry of the rotation matrix for column vectors.</summary>
    public double Entry(int row, int column) => ((row * 3) + column) switch
    {
        0 => 1 - (2 * ((Y * Y) + (Z * Z))),
        1 => 2 * ((X * Y) - (W * Z)),
        2 => 2 * ((X * Z) + (W * Y)),
        3 => 2 * ((X * Y) + (W * Z)),
        4 => 1 - (2 * ((X * X) + (Z * Z))),
        5 => 2 * ((Y * Z) - (W * X)),
        6 => 2 * ((X * Z) - (W * Y)),
        7 => 2 * ((Y * Z) + (W * X)),
        _ => 1 - (2 * ((X * X) + (Y * Y))),
    };

    private BvhRotation Normalized()
    {
        double length = Math.Sqrt((X * X) + (Y * Y) + (Z * Z) + (W * W));
        return new BvhRotation(X / length, Y / length, Z / length, W / length);
    }
}
