using System.Text;

namespace NeuronMocap.Bvh;

/// <summary>
/// Time from one frame to the next: a fraction of seconds in lowest terms, so that frame times add up without drift. The default value is no
/// time, 0 s. Immutable; thread-safe.
/// </summary>
public readonly record struct BvhFrameTime
{
    private const double SlowestRate = 1 / 3600.0;
    private const double FastestRate = 1e6;
    private const decimal RateTolerance = 1e-10m;

    private readonly long _denominatorLessOne;

    /// <summary>Makes a time; 1 and 120 is that of Axis Neuron at 120 Hz.</summary>
    /// <param name="numerator">Seconds, above 0.</param>
    /// <param name="denominator">What they are divided by, above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">One of them is not above 0.</exception>
    public BvhFrameTime(long numerator, long denominator)
    {
        if (numerator <= 0)
            throw new ArgumentOutOfRangeException(nameof(numerator), numerator, "The frame time must be more than 0 s.");
        if (denominator <= 0)
            throw new ArgumentOutOfRangeException(nameof(denominator), denominator, "The denominator must be more than 0.");

        long divisor = GreatestDivisor(numerator, denominator);
        Numerator = numerator / divisor;
        _denominatorLessOne = (denominator / divisor) - 1;
    }

    /// <summary>1/120 s, the rate of a suit with fewer than 18 sensors (manual section 1.3): assumed where a file does not say.</summary>
    public static BvhFrameTime Default => new(1, 120);

    /// <summary>Seconds, to be divided by <see cref="Denominator"/>; 0 in the default value only.</summary>
    public long Numerator { get; }

    /// <summary>What <see cref="Numerator"/> is divided by, at least 1.</summary>
    public long Denominator => _denominatorLessOne + 1;

    /// <summary>The time in seconds, as the nearest double.</summary>
    public double Seconds => (double)Numerator / Denominator;

    /// <summary>Frames per second, as the nearest double; infinite in the default value.</summary>
    public double FrameRate => (double)Denominator / Numerator;

    /// <summary>
    /// The time of a rate: 120 gives 1/120 s, 59.94 gives 50/2997 s and 60 / 1.001 gives 1001/60000 s. It is the simplest fraction within a
    /// tenth of a billionth of the rate, which is far more than a double's error and less than what parts two rates that are meant.
    /// </summary>
    /// <param name="frameRate">Frames per second: 1/3600 to a million.</param>
    /// <returns>The time.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The rate is not one of those, or not a number.</exception>
    public static BvhFrameTime FromFrameRate(double frameRate)
    {
        if (frameRate is not (>= SlowestRate and <= FastestRate))
            throw new ArgumentOutOfRangeException(nameof(frameRate), frameRate, "The rate must be 1/3600 to a million frames per second.");

        decimal rate = (decimal)frameRate;
        (long numerator, long denominator) = SimplestFraction(rate - (rate * RateTolerance), rate + (rate * RateTolerance));
        return new BvhFrameTime(denominator, numerator);
    }

    /// <summary>
    /// Reads the text after "Frame Time:" of a file and finds the time that was rounded: 0.008 is 1/120, 0.017 is 1/60, 0.033 is 1/30, 0.010 is
    /// 1/100 and 0.033367 is 1001/30000 s. A file says 1/125 with one more digit, 0.0080. Where no usual rate fits the digits that are
    /// there, the text is taken by its word.
    /// </summary>
    /// <param name="text">A decimal number, without space around it.</param>
    /// <param name="time">The time.</param>
    /// <returns>False when it is not a number, or not one from 1 µs to 1 h.</returns>
    public static bool TryParse(string? text, out BvhFrameTime time) =>
        BvhFrameTimeText.TryParse(Encoding.UTF8.GetBytes(text ?? ""), out _, out time);

    /// <summary>
    /// The time as a file has it: with six decimals, or as many more, up to fifteen, as <see cref="TryParse"/> needs to read the same time.
    /// </summary>
    public override string ToString() => BvhFrameTimeText.Create(this);

    // The fraction of the smallest denominator between two positive numbers, both included, by their continued fractions. Any numbers: times or rates.
    internal static (long Numerator, long Denominator) SimplestFraction(decimal lowest, decimal highest)
    {
        decimal whole = decimal.Floor(lowest);
        if (whole == lowest)
            return ((long)whole, 1);
        if (whole + 1 <= highest)
            return ((long)whole + 1, 1);

        (long numerator, long denominator) = SimplestFraction(1 / (highest - whole), 1 / (lowest - whole));
        return (checked(((long)whole * numerator) + denominator), numerator);
    }

    private static long GreatestDivisor(long a, long b)
    {
        while (b != 0)
            (a, b) = (b, a % b);

        return a;
    }
}
