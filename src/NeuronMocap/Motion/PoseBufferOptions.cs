namespace NeuronMocap.Motion;

/// <summary>Options of a <see cref="PoseBuffer"/>. The values are copied when used; later changes have no effect.</summary>
public sealed class PoseBufferOptions
{
    /// <summary>
    /// Delay of the output behind the mean arrival of the frames. The default is 30 ms. The delay must be much shorter than the duration of
    /// <see cref="Capacity"/> frames.
    /// </summary>
    /// <remarks>
    /// One frame plus the usual lateness of the slowest frames is enough. A later frame to interpolate towards is then nearly always available.
    /// </remarks>
    public TimeSpan Delay { get; set; } = TimeSpan.FromMilliseconds(30);

    /// <summary>
    /// Time for which the motion continues without new frames, while it slows down steadily to a stop. The default is 50 ms; 0 stops at the latest
    /// frame. The pose moves no further than the latest speed covers in half of this time.
    /// </summary>
    public TimeSpan MaxExtrapolation { get; set; } = TimeSpan.FromMilliseconds(50);

    /// <summary>The interpolation of poses between frames. The default is <see cref="PoseInterpolationMethod.Cubic"/>.</summary>
    public PoseInterpolationMethod Interpolation { get; set; } = PoseInterpolationMethod.Cubic;

    /// <summary>
    /// Capacity in frames of 1.7 KB each, 8 to 4096, rounded up to a power of two. The default is 64. If the buffer is full, further frames are
    /// dropped and counted.
    /// </summary>
    public int Capacity { get; set; } = 64;

    internal static PoseBufferOptions CopyChecked(PoseBufferOptions? options)
    {
        options ??= new PoseBufferOptions();
        if (options.Delay < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(options), options.Delay, $"Delay is {options.Delay}; it must not be negative.");
        if (options.MaxExtrapolation < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(options), options.MaxExtrapolation, $"MaxExtrapolation is {options.MaxExtrapolation}; it must not be negative.");
        if (options.Capacity is < 8 or > 4096)
            throw new ArgumentOutOfRangeException(nameof(options), options.Capacity, $"Capacity is {options.Capacity}; it must be 8 to 4096.");

        return (PoseBufferOptions)options.MemberwiseClone();
    }
}
