namespace NeuronMocap.Motion;

/// <summary>How a <see cref="PoseBuffer"/> plays what it is given. Copied when used; later changes have no effect.</summary>
public sealed class PoseBufferOptions
{
    /// <summary>
    /// How far behind the mean arrival of the frames the output is. One frame and the usual lateness of the slowest is enough: then there is
    /// nearly always a later frame to move towards. Default: 30 ms. Must be far less than the time that <see cref="Capacity"/> frames take.
    /// </summary>
    public TimeSpan Delay { get; set; } = TimeSpan.FromMilliseconds(30);

    /// <summary>
    /// For how long the motion goes on when no frame comes, slowing down steadily to a stop: the pose is never further ahead than the
    /// newest speed reaches in half of this time. 0: it stops at the newest frame. Default: 50 ms.
    /// </summary>
    public TimeSpan MaxExtrapolation { get; set; } = TimeSpan.FromMilliseconds(50);

    /// <summary>How poses between frames are made. Default: <see cref="PoseInterpolationMethod.Cubic"/>.</summary>
    public PoseInterpolationMethod Interpolation { get; set; } = PoseInterpolationMethod.Cubic;

    /// <summary>Frames that there is room for, each 1.7 KB; what comes while it is full is dropped and counted. From 8 to 4096, rounded up to a power of two. Default: 64.</summary>
    public int Capacity { get; set; } = 64;

    internal static PoseBufferOptions CopyChecked(PoseBufferOptions? options)
    {
        options ??= new PoseBufferOptions();
        if (options.Delay < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(options), options.Delay, "The delay must not be negative.");
        if (options.MaxExtrapolation < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(options), options.MaxExtrapolation, "The extrapolation time must not be negative.");
        if (options.Capacity is < 8 or > 4096)
            throw new ArgumentOutOfRangeException(nameof(options), options.Capacity, "There must be room for 8 to 4096 frames.");

        return (PoseBufferOptions)options.MemberwiseClone();
    }
}
