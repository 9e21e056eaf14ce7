namespace NeuronMocap.Bvh;

/// <summary>
/// Three angles in degrees, in the order of their application. Every rotation has two such triples, and each of those may have whole turns added: of
/// all of them, the one is chosen that is nearest to another triple, the neighbour's in time. Programs that interpolate the curves of a file
/// one by one, as Blender and MotionBuilder do, would spin a joint where the triples jump.
/// </summary>
internal readonly record struct BvhEulerTriple(double First, double Second, double Third)
{
    // The cosine of the second angle below which the first and the third turn about the same line. Their parts are the neighbour's to choose then; that
    // costs less than this in radians.
    private const double GimbalLockCosine = 1e-7;

    private const double DegreesPerRadian = 180 / Math.PI;

    /// <summary>The triple of a rotation that is nearest to another.</summary>
    /// <param name="rotation">The rotation.</param>
    /// <param name="axes">The axes of the three angles, all different: 0 for X, 1 for Y, 2 for Z.</param>
    /// <param name="near">The triple to be near to.</param>
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

    /// <summary>Of the triples that describe the same rotation, with all axes different, the nearest to another.</summary>
    public BvhEulerTriple Nearest(BvhEulerTriple near)
    {
        BvhEulerTriple one = Unwrap(near);
        BvhEulerTriple other = new BvhEulerTriple(First + 180, 180 - Second, Third + 180).Unwrap(near);
        return other.Distance(near) < one.Distance(near) ? other : one;
    }

    /// <summary>This, or another one where this is no rotation: one row of NaN shall not spoil those after it.</summary>
    public BvhEulerTriple Or(BvhEulerTriple other) => double.IsFinite(First + Second + Third) ? this : other;

    private static double Square(double value) => value * value;

    private static double Unwrap(double angle, double near) => angle + (360 * Math.Round((near - angle) / 360));

    private BvhEulerTriple Unwrap(BvhEulerTriple near) =>
        new(Unwrap(First, near.First), Unwrap(Second, near.Second), Unwrap(Third, near.Third));

    private double Distance(BvhEulerTriple other) =>
        Math.Abs(First - other.First) + Math.Abs(Second - other.Second) + Math.Abs(Third - other.Third);
}
