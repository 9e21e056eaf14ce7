namespace NeuronMocap.Calculation;

/// <summary>How a calculation export is read, and what such a file does not say itself. Copied when used; later changes have no effect.</summary>
public sealed class CalculationReadOptions
{
    /// <summary>Frames per second of a full set of sensors that records to a file.</summary>
    public const double DefaultFrameRate = 120;

    /// <summary>
    /// Whether anything that would have to be repaired is refused with a <see cref="CalculationFormatException"/>. Default: false, which lists it
    /// in <see cref="CalculationDocument.Repairs"/>.
    /// </summary>
    public bool Strict { get; set; }

    /// <summary>
    /// Told how many bytes of a stream or file have been read, on the reading thread, after every piece of at most about 64 KiB; null for nobody. An
    /// exception of it ends the reading and reaches the caller.
    /// </summary>
    public IProgress<long>? Progress { get; set; }

    /// <summary>
    /// Frames per second, a positive number. Default: null, which takes the rate of the file's header, a line <c>Frame Rate:</c>
    /// (<see cref="CalculationTextFormat.WithFrameRate"/>), or 120 where there is none. Exports of Axis Neuron have none; all known recordings have 120.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The number is not positive, or infinite.</exception>
    public double? FrameRate
    {
        get;
        set => field = value is null || (value > 0 && double.IsFinite(value.Value))
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The frame rate must be a positive number.");
    }

    /// <summary>Name that the frames get; what does not fit into 32 bytes of UTF-8 is cut off. Default: Char00, as Axis Neuron calls its first avatar.</summary>
    public string AvatarName { get; set; } = "Char00";

    /// <summary>Number that the frames' avatar gets, from 0. Default: 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The number is below 0.</exception>
    public int AvatarIndex
    {
        get;
        set => field = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The avatar number must not be negative.");
    }

    internal CalculationReadOptions Copy() => (CalculationReadOptions)MemberwiseClone();
}
