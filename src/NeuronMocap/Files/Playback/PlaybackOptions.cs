using NeuronMocap.Skeleton;

namespace NeuronMocap.Recording;

/// <summary>
/// How a file is to be read that holds a stream: a recording, or a raw dump of the bytes. What is left null is taken from the file. Copied where
/// it is used.
/// </summary>
public sealed class PlaybackOptions
{
    /// <summary>
    /// Frames of each avatar per second of a raw dump, whose bytes have no times: 0.01 to 100,000. Null, the default: the rate of the timecodes, which
    /// Axis Studio's frames carry where its server has a clock, or 120, Axis Neuron's rate with fewer than 18 sensors (manual section 2.1). A recording
    /// knows when each byte came: it has to be null there.
    /// </summary>
    public double? FrameRate { get; set; }

    /// <summary>
    /// Order of the rotation values. Null, the default: what each frame says, or the recording, or YXZ, as in
    /// <see cref="NeuronReaderOptions.RotationOrder"/>.
    /// </summary>
    public RotationOrder? RotationOrder { get; set; }

    /// <summary>Naming of spine and neck. Null, the default: what the recording says, or that of the manual's Appendix A.</summary>
    public SkeletonVariant? SkeletonVariant { get; set; }

    /// <summary>
    /// Largest number of values that a packet may announce, 1 to 1,000,000. Null, the default: that of the reader that recorded, so that the same bytes
    /// are skipped; 10,224 for a raw dump.
    /// </summary>
    public int? MaxValues { get; set; }

    internal static PlaybackOptions CopyChecked(PlaybackOptions? options)
    {
        options ??= new PlaybackOptions();
        return options.FindFault() is { } fault ? throw new ArgumentException(fault, nameof(options)) : (PlaybackOptions)options.MemberwiseClone();
    }

    private string? FindFault()
    {
        if (FrameRate is { } rate && !(rate is >= 0.01 and <= 100_000))
            return $"FrameRate is {rate}; it must be 0.01 to 100,000 Hz, or null.";
        if (RotationOrder is { } order && !Enum.IsDefined(typeof(RotationOrder), order))
            return $"RotationOrder is {order}; it must be one of the six orders, or null.";
        if (SkeletonVariant is { } variant && !Enum.IsDefined(typeof(SkeletonVariant), variant))
            return $"SkeletonVariant is {variant}; it must be Neck1, Spine3 or null.";
        if (MaxValues is < 1 or > 1_000_000)
            return $"MaxValues is {MaxValues}; it must be 1 to 1,000,000, or null.";

        return null;
    }
}
