namespace NeuronMocap.Calculation;

/// <summary>How a calculation export is read, and what such a file does not say itself.</summary>
public sealed class CalculationReadOptions
{
    /// <summary>Frames per second of a full set of sensors that records to a file.</summary>
    public const double DefaultFrameRate = 120;

    internal static readonly CalculationReadOptions Default = new();

    /// <summary>
    /// Whether anything that would have to be repaired is refused with a <see cref="CalculationFormatException"/>. Default: false, which lists it
    /// in <see cref="CalculationDocument.Repairs"/>.
    /// </summary>
    public bool Strict { get; init; }

    /// <summary>Frames per second, which no export says: a positive number. Default: 120, which all known recordings have.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The number is not positive, or infinite.</exception>
    public double FrameRate
    {
        get;
        init => field = value > 0 && double.IsFinite(value)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The frame rate is a positive number.");
    } = DefaultFrameRate;

    /// <summary>Name that the frames get; at most 32 bytes of UTF-8. Default: Char00, as Axis Neuron calls its first avatar.</summary>
    public string AvatarName { get; init; } = "Char00";

    /// <summary>Number that the frames' avatar gets. Default: 0.</summary>
    public int AvatarIndex { get; init; }
}
