using System.Text;
using NeuronMocap.Timing;

namespace NeuronMocap.Bvh;

/// <summary>
/// Represents the time from one frame to the next as a fraction of seconds in lowest terms. Frame times therefore add up without drift. The default
/// value is 0 s, which is not a valid frame time. Immutable; thread-safe.
/// </summary>
public readonly record struct BvhFrameTime
{
    private const double SlowestRate = 1 / 3600.0;
    private const double FastestRate = 1e6;
    private const decimal RateTolerance = 1e-10m;

    private readonly long _denominatorLessOne;

    /// <summary>Creates a frame time. For example, 1 and 120 give the frame time of Axis Neuron at 120 Hz.</summary>
    /// <param name="numerator">Seconds, above 0.</param>
    /// <param name="denominator">The divisor, above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">One of the values is not above 0.</exception>
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

    /// <summary>
    /// 1/120 s, the frame time of a suit with fewer than 18 sensors (manual section 1.3). Used when a file has no usable frame time.
    /// </summary>
    public static BvhFrameTime Default => new(1, 120);

    /// <summary>The seconds, to be divided by <see cref="Denominator"/>. Only the default value has 0.</summary>
    public long Numerator { get; }

    /// <summary>The divisor of <see cref="Numerator"/>, at least 1.</summary>
    public long Denominator => _denominatorLessOne + 1;

    /// <summary>The time in seconds, as the nearest double.</summary>
    public double Seconds => (double)Numerator / Denominator;

    /// <summary>Frames per second, as the nearest double; infinite for the default value.</summary>
    public double FrameRate => (double)Denominator / Numerator;

    /// <summary>
    /// Creates the frame time of a rate: 120 gives 1/120 s, 59.94 gives 50/2997 s and 60 / 1.001 gives 1001/60000 s.
    /// </summary>
    /// <remarks>
    /// The result is the simplest fraction within a relative distance of 1e-10 from the rate. This tolerance is much larger than the rounding error
    /// of a double, and smaller than the difference between two common rates.
    /// </remarks>
    /// <param name="frameRate">Frames per second: 1/3600 to a million.</param>
    /// <returns>The time.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The rate is out of range or not a number.</exception>
    public static BvhFrameTime FromFrameRate(double frameRate)
    {
        if (frameRate is not (>= SlowestRate and <= FastestRate))
            throw new ArgumentOutOfRangeException(nameof(frameRate), frameRate, "The rate must be 1/3600 to a million frames per second.");

        decimal rate = (decimal)frameRate;
        (long numerator, long denominator) = SimplestFraction.Between(rate - (rate * RateTolerance), rate + (rate * RateTolerance));
        return new BvhFrameTime(denominator, numerator);
    }

    /// <summary>
    /// Reads the text after "Frame Time:" of a file and finds the time that was rounded.
    /// </summary>
    /// <remarks>
    /// 0.008 stands for 1/120 s, 0.017 for 1/60 s, 0.033 for 1/30 s, 0.010 for 1/100 s and 0.033367 for 1001/30000 s. A file writes 1/125 s with
    /// one more digit, 0.0080. If no usual rate matches the digits, the text is taken literally.
    /// </remarks>
    /// <param name="text">A decimal number without surrounding white space.</param>
    /// <param name="time">The frame time.</param>
    /// <returns>True if the text is a number from 1 µs to 1 h.</returns>
    public static bool TryParse(string? text, out BvhFrameTime time) =>
        BvhFrameTimeText.TryParse(Encoding.UTF8.GetBytes(text ?? ""), out _, out time);

    /// <summary>
    /// Formats the time as in a file: with six decimals, or with as many as <see cref="TryParse"/> needs to read the same time, up to fifteen.
    /// </summary>
    public override string ToString() => BvhFrameTimeText.Create(this);

    private static long GreatestDivisor(long a, long b)
    {
        while (b != 0)
            (a, b) = (b, a % b);

        return a;
    }
}
