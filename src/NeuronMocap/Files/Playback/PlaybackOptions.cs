using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Recording;

/// <summary>
/// Options for reading a recording, or a raw dump of the bytes of a stream. Values that are null come from the file. The options are copied when
/// used; later changes have no effect.
/// </summary>
public sealed class PlaybackOptions
{
    /// <summary>
    /// Frames per second of each avatar in a raw dump, whose bytes have no times: 0.01 to 100,000. A recording contains the time of each byte, so
    /// this must be null for a recording.
    /// </summary>
    /// <remarks>
    /// Null, the default, uses the rate of the timecodes, which frames of Axis Studio contain if its server has a clock. Without timecodes, it is
    /// 120, the rate of Axis Neuron with fewer than 18 sensors (manual section 1.3).
    /// </remarks>
    public double? FrameRate { get; set; }

    /// <summary>
    /// The rotation order. Null, the default, uses the order of each frame, or that of the recording, or YXZ, as in
    /// <see cref="NeuronReaderOptions.RotationOrder"/>.
    /// </summary>
    public RotationOrder? RotationOrder { get; set; }

    /// <summary>The names of spine and neck. Null, the default, uses those of the recording, or those of the manual's Appendix A.</summary>
    public SkeletonVariant? SkeletonVariant { get; set; }

    /// <summary>
    /// Maximum number of values that a packet may declare, 1 to 1,000,000. Null, the default, uses the limit of the reader that recorded, which
    /// skips the same bytes. For a raw dump, it is 10,224.
    /// </summary>
    public int? MaxValues { get; set; }

    /// <summary>
    /// The clock that the playback follows. Null, the default, follows real time. Frames are due, and have their timestamps, on this clock.
    /// </summary>
    /// <remarks><see cref="RecordingPlayer.Speed"/> applies, too. At <see cref="RecordingPlayer.MaxSpeed"/> the clock has no effect.</remarks>
    public ManualClock? Clock { get; set; }

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
        if (MaxValues is < 1 or > ProtocolConstants.LargestMaxValues)
            return $"MaxValues is {MaxValues}; it must be 1 to 1,000,000, or null.";

        return null;
    }
}
