using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public sealed class HalfAnglesTests
{
    private const double LargestError = 2; // units in the last place

    // If a result is near zero, its last place is not a useful measure. The error stays below this limit.
    private const double NearZero = 1e-9;

    [Fact]
    public void Usual_angles_are_accurate_to_two_ulps() =>
        AssertRight(Enumerable.Range(0, 720_000).Select(i => (i - 360_000) / 1000f));

    [Fact]
    public void Angles_around_every_quadrant_are_right() =>
        AssertRight(Enumerable.Range(-40, 80).SelectMany(quadrant => Around(90 * quadrant)));

    [Fact]
    public void Every_finite_angle_is_right()
    {
        var random = new Random(11);
        AssertRight(Enumerable.Range(0, 200_000).Select(_ => BitConverter.Int32BitsToSingle(random.Next(int.MinValue, int.MaxValue))).Where(float.IsFinite));
        AssertRight([float.MaxValue, float.MinValue, float.Epsilon, -float.Epsilon, 1 << 24, (1 << 24) + 2, -(1 << 24) - 2, 1e9f, -1e20f]);
    }

    [Fact]
    public void A_NaN_angle_affects_no_other()
    {
        float[] angles = [float.NaN, 90, float.PositiveInfinity, -90, float.NegativeInfinity, 180];
        (float[] sines, float[] cosines) = Compute(angles);

        foreach (int i in (int[])[0, 2, 4])
            Assert.True(float.IsNaN(sines[i]) && float.IsNaN(cosines[i]));
        foreach (int i in (int[])[1, 3, 5])
        {
            AssertNear(Math.Sin(angles[i] * Math.PI / 360), sines[i], angles[i]);
            AssertNear(Math.Cos(angles[i] * Math.PI / 360), cosines[i], angles[i]);
        }
    }

    private static IEnumerable<float> Around(float degrees)
    {
        float value = degrees;
        for (int i = 0; i < 20; i++)
            value = MathF.BitDecrement(value);
        for (int i = 0; i < 40; i++, value = MathF.BitIncrement(value))
            yield return value;
    }

    private static void AssertRight(IEnumerable<float> angles)
    {
        float[] degrees = [.. angles];
        (float[] sines, float[] cosines) = Compute(degrees);
        for (int i = 0; i < degrees.Length; i++)
        {
            // The remainder is exact in double precision too.
            double radians = (double)degrees[i] % 720 * (Math.PI / 360);
            AssertNear(Math.Sin(radians), sines[i], degrees[i]);
            AssertNear(Math.Cos(radians), cosines[i], degrees[i]);
        }
    }

    private static void AssertNear(double expected, float actual, float degrees)
    {
        double unit = MathF.BitIncrement(MathF.Abs((float)expected)) - (double)MathF.Abs((float)expected);
        if (!(Math.Abs(actual - expected) <= Math.Max(LargestError * unit, NearZero)))
            Assert.Fail($"{degrees:R} degrees: {actual:R} instead of {expected:R}.");
    }

    private static (float[] Sines, float[] Cosines) Compute(float[] degrees)
    {
        int length = (degrees.Length + HalfAngles.Granularity - 1) / HalfAngles.Granularity * HalfAngles.Granularity;
        float[] angles = new float[length];
        float[] sines = new float[length];
        float[] cosines = new float[length];
        degrees.CopyTo(angles, 0);
        HalfAngles.SinCos(angles, sines, cosines);
        return (sines, cosines);
    }
}
