namespace NeuronMocap.Timing;

internal static class SimplestFraction
{
    // The fraction with the smallest denominator in a range of positive numbers, bounds included, by continued fractions. Works for times and for
    // rates.
    public static (long Numerator, long Denominator) Between(decimal lowest, decimal highest)
    {
        decimal whole = decimal.Floor(lowest);
        if (whole == lowest)
            return ((long)whole, 1);
        if (whole + 1 <= highest)
            return ((long)whole + 1, 1);

        (long numerator, long denominator) = Between(1 / (highest - whole), 1 / (lowest - whole));
        return (checked(((long)whole * numerator) + denominator), numerator);
    }
}
