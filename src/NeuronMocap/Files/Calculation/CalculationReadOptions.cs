namespace NeuronMocap.Calculation;

/// <summary>
/// Options for reading a calculation export, including values that the file does not contain. The values are copied when used; later changes have
/// no effect.
/// </summary>
public sealed class CalculationReadOptions
{
    /// <summary>The frame rate of a full set of sensors that records to a file.</summary>
    public const double DefaultFrameRate = 120;

    /// <summary>
    /// Whether to throw a <see cref="CalculationFormatException"/> at the first defect, instead of repairing it. The default is false, which lists
    /// repairs in <see cref="CalculationDocument.Repairs"/>.
    /// </summary>
    public bool Strict { get; set; }

    /// <summary>
    /// Receives the number of bytes read from a stream or file; may be null. It is called on the reading thread, after every piece of at most about
    /// 64 KiB. An exception from it ends the reading and reaches the caller.
    /// </summary>
    public IProgress<long>? Progress { get; set; }

    /// <summary>
    /// Frames per second, a positive number. The default is null, which uses the line <c>Frame Rate:</c> of the header
    /// (<see cref="CalculationTextFormat.WithFrameRate"/>), or 120 without that line. Exports of Axis Neuron do not have the line; all known
    /// recordings have 120.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not positive or not finite.</exception>
    public double? FrameRate
    {
        get;
        set => field = value is null || (value > 0 && double.IsFinite(value.Value))
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The frame rate must be a positive number.");
    }

    /// <summary>
    /// Avatar name of the frames, truncated to 32 bytes of UTF-8. The default is Char00, the name that Axis Neuron gives its first avatar.
    /// </summary>
    public string AvatarName { get; set; } = "Char00";

    /// <summary>Avatar number of the frames, from 0. The default is 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative.</exception>
    public int AvatarIndex
    {
        get;
        set => field = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The avatar number must not be negative.");
    }

    internal CalculationReadOptions Copy() => (CalculationReadOptions)MemberwiseClone();
}
