namespace NeuronMocap.Bvh;

/// <summary>
/// Three angles in degrees, in the order in which they are applied.
/// </summary>
/// <remarks>
/// Every rotation has two such triples, and whole turns can be added to each angle. Of all these triples, the one nearest to a neighbouring frame
/// is chosen. Some programs, such as Blender and MotionBuilder, interpolate the curves of a file independently. In such a program, a jump between
/// triples would spin the joint.
/// </remarks>
internal readonly record struct BvhEulerTriple(double First, double Second, double Third)
{
    // Below this cosine of the second angle, the first and the third angle turn about the same line. The neighbouring frame then decides how to
    // divide the turn between them. The error is smaller than this value in radians.
    private const double GimbalLockCosine = 1e-7;

    private const double DegreesPerRadian = 180 / Math.PI;

    /// <summary>Finds the triple of a rotation that is nearest to another triple.</summary>
    /// <param name="rotation">The rotation.</param>
    /// <param name="axes">The axes of the three angles, all different: 0 for X, 1 for Y, 2 for Z.</param>
    /// <param name="near">The other triple.</param>
    public static BvhEulerTriple Of(BvhRotation rotation, (int First, int Second, int Third) axes, BvhEulerTriple near)
    {
        (int i, int j, int k) = axes;
        int sign = (j - i + 3) % 3 == 1 ? 1 : -1;
        double cosine = Math.Sqrt(Square(rotation.Entry(i, i)) + Square(rotation.Entry(i, j)));
        double second = Math.Atan2(sign * rotation.Entry(i, k), cosine) * DegreesPerRadian;
        if (cosine < GimbalLockCosine)
        {
            BvhRotation rest = rotation * BvhRotation.About(k, -near.Third);
            double sum = Math.Atan2(sign * rest.Entry(k, j), rest.Entry(j, j)) * DegreesPerRadian;
            return new BvhEulerTriple(sum, second, near.Third).Unwrap(near);
        }

        double first = Math.Atan2(-sign * rotation.Entry(j, k), rotation.Entry(k, k)) * DegreesPerRadian;
        double third = Math.Atan2(-sign * rotation.Entry(i, j), rotation.Entry(i, i)) * DegreesPerRadian;
        return new BvhEulerTriple(first, second, third).Nearest(near);
    }

    /// <summary>Finds the triple of the same rotation that is nearest to another triple. All three axes must be different.</summary>
    public BvhEulerTriple Nearest(BvhEulerTriple near)
    {
        BvhEulerTriple one = Unwrap(near);
        BvhEulerTriple other = new BvhEulerTriple(First + 180, 180 - Second, Third + 180).Unwrap(near);
        return other.Distance(near) < one.Distance(near) ? other : one;
    }

    /// <summary>Returns this triple, or the other one if this is not finite. One row of NaN must not affect the rows after it.</summary>
    public BvhEulerTriple Or(BvhEulerTriple other) => double.IsFinite(First + Second + Third) ? this : other;

    private static double Square(double value) => value * value;

    private static double Unwrap(double angle, double near) => angle + (360 * Math.Round((near - angle) / 360));

    private BvhEulerTriple Unwrap(BvhEulerTriple near) =>
        new(Unwrap(First, near.First), Unwrap(Second, near.Second), Unwrap(Third, near.Third));

    private double Distance(BvhEulerTriple other) =>
        Math.Abs(First - other.First) + Math.Abs(Second - other.Second) + Math.Abs(Third - other.Third);
}
