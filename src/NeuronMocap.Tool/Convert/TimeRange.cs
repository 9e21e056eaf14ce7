using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Convert;

/// <summary>The part of a file that is wanted, in seconds since its beginning.</summary>
/// <param name="From">Where it begins; null for the beginning.</param>
/// <param name="To">Where it ends, itself not included; null for the end.</param>
internal readonly record struct TimeRange(double? From, double? To)
{
    // A frame that is due at the very edge belongs where its exact time says, whatever its rounded one is.
    private const double Tolerance = 1e-6;

    public bool IsAll => From is null && To is null;

    public TimeSpan Start => TimeSpan.FromSeconds(From ?? 0);

    public bool Contains(TimeSpan time) => time >= Start && (To is not { } end || time < TimeSpan.FromSeconds(end));

    /// <summary>The frames of a take at an even rate that lie in the range.</summary>
    /// <param name="count">Number of frames of the take.</param>
    /// <param name="rate">Frames per second.</param>
    /// <returns>The first frame, and how many there are.</returns>
    /// <exception cref="NeuronException">There is none.</exception>
    public (long First, long Count) FramesOf(long count, double rate)
    {
        long first = From is { } from ? (long)Math.Ceiling((from * rate) - Tolerance) : 0;
        long end = To is { } to ? Math.Min(count, (long)Math.Ceiling((to * rate) - Tolerance)) : count;
        return first < end
            ? (first, end - first)
            : throw new NeuronException(Quantity.Format($"No frames remain: the take ends at {count / rate:0.###} s."));
    }
}
