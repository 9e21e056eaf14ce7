using NeuronMocap.Skeleton;

namespace NeuronMocap.Gltf;

/// <summary>An avatar in a GLB file: a figure, and an animation if it has frames. Not thread-safe.</summary>
public sealed class GlbAvatar
{
    private readonly PoseRepair _repair;
    private readonly PoseTiming _timing;
    private readonly Func<bool> _isClosed;

    internal GlbAvatar(string name, SkeletonBody body, int accentColor, KeySpool spool, GlbOptions options, Func<bool> isClosed)
    {
        Name = name;
        Body = PoseRepair.Of(body);
        AccentColor = accentColor;
        Animation = new PoseAnimation(spool, options);
        _repair = new PoseRepair(Body);
        _timing = new PoseTiming(Animation, options.FrameRate);
        _isClosed = isClosed;
    }

    /// <summary>Gets the name of the figure and its animation, different from those of the file's other avatars and from bones' names.</summary>
    public string Name { get; }

    /// <summary>Gets the sizes of the figure. Values that are not finite are replaced by those of the default body.</summary>
    public SkeletonBody Body { get; }

    /// <summary>Gets the colour of joints and visor, 0xRRGGBB in sRGB.</summary>
    public int AccentColor { get; }

    /// <summary>Gets the number of frames in the animation.</summary>
    public long FrameCount { get; private set; }

    /// <summary>Gets the number of frames that were left out because their times do not follow that of the frame before.</summary>
    public long SkippedFrames { get; private set; }

    /// <summary>
    /// Gets the number of frames with values that are not numbers, or are no rotations. A bone with such a value keeps its last valid transform.
    /// </summary>
    public long RepairedFrames { get; private set; }

    internal PoseAnimation Animation { get; }

    /// <summary>Adds a frame to the animation.</summary>
    /// <remarks>
    /// <para>
    /// In a gap, the figure keeps its pose until shortly before the next frame. A gap is longer than a second, and more than four times as long as
    /// the step before it.
    /// </para>
    /// <para>
    /// Times in the file are seconds in single precision. Frames whose times are equal in it are left out: at 120 Hz, this begins after 18 hours.
    /// </para>
    /// </remarks>
    /// <param name="time">The time since the start of the file, not negative. Avatars of a file share this start.</param>
    /// <param name="pose">59 transforms relative to the parents, in <see cref="Bone"/> order; centimetres.</param>
    /// <exception cref="ArgumentOutOfRangeException">The time is negative.</exception>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    /// <exception cref="NeuronException">The file would become larger than 4 GiB. What was written so far remains valid.</exception>
    /// <exception cref="IOException">The temporary file cannot be written.</exception>
    /// <exception cref="ObjectDisposedException">The writer is disposed.</exception>
    public void WriteFrame(TimeSpan time, ReadOnlySpan<BoneTransform> pose)
    {
        if (time < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(time), time, "The time must not be negative.");

        ForwardKinematics.CheckPose(pose, nameof(pose));
        ObjectDisposedException.ThrowIf(_isClosed(), this);
        if (!_repair.Set(pose))
            RepairedFrames++;

        if (_timing.Add(time.TotalSeconds, _repair.Pose))
            FrameCount++;
        else
            SkippedFrames++;
    }
}
