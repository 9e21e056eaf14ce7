using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>How a reader's frames become BVH files: <see cref="NeuronReader.ExportBvh"/>. Copied when used; later changes have no effect.</summary>
public sealed class BvhExportOptions
{
    /// <summary>Largest number of frames that are kept waiting unless another is asked for: 34 s of one avatar at 120 Hz, 6 MB.</summary>
    public const int DefaultCapacity = 4096;

    /// <summary>The avatar to export, by its number on the server; null, the default, for the one whose frame comes first.</summary>
    public int? AvatarIndex { get; set; }

    /// <summary>
    /// Whether every avatar gets a file of its own: for "take.bvh" these are "take-avatar0.bvh", "take-avatar1.bvh" and so on; over UDP those of the second server
    /// "take-sender1-avatar0.bvh". At most 64.
    /// </summary>
    public bool FilePerAvatar { get; set; }

    /// <summary>Whether files that are there already are replaced; unless set they are an error.</summary>
    public bool Overwrite { get; set; }

    /// <summary>
    /// The actor's body; null, the default, to find it out. The OFFSETs are, in this order: the positions of the stream, where it has displacement; this body; those
    /// of the BVH header that the command channel answers (<see cref="NeuronReaderOptions.CommandPort"/>); those of the bone sizes that it answers; the
    /// default body's of the manual's Appendix B.
    /// </summary>
    public SkeletonBody? Body { get; set; }

    /// <summary>
    /// How long the first row of an avatar waits for what the command channel answers, because the hierarchy stands in front of it; 2 s unless set. Frames
    /// wait in the queue meanwhile. Without <see cref="NeuronReaderOptions.CommandPort"/> there is nothing to wait for.
    /// </summary>
    public TimeSpan HeaderTimeout { get; set; } = TimeSpan.FromSeconds(2);

    /// <summary>Time from one frame to the next; null, the default, to measure it: <see cref="BvhTakeOptions.FrameTime"/>.</summary>
    public BvhFrameTime? FrameTime { get; set; }

    /// <summary>What becomes of frames that were lost on the way; they are repeated unless set.</summary>
    public BvhGapHandling GapHandling { get; set; }

    /// <summary>How the text is laid out; as in Axis Neuron's files unless set.</summary>
    public BvhTextFormat TextFormat { get; set; } = BvhTextFormat.AxisNeuron;

    /// <summary>Largest number of frames that can wait for the disk, 1 to 1,048,576: <see cref="FrameQueue.Capacity"/>.</summary>
    public int Capacity { get; set; } = DefaultCapacity;

    /// <summary>Number of frames received, of all avatars that are exported, to end after; null, the default, for no end.</summary>
    public long? MaxFrames { get; set; }

    internal static BvhExportOptions CopyChecked(BvhExportOptions? options)
    {
        options ??= new BvhExportOptions();
        if (options.HeaderTimeout < TimeSpan.Zero || options.HeaderTimeout > TimeSpan.FromMinutes(5))
            throw new ArgumentOutOfRangeException(nameof(options), options.HeaderTimeout, "HeaderTimeout must be 0 to 5 minutes.");
        if (options.Capacity is < 1 or > 1 << 20)
            throw new ArgumentOutOfRangeException(nameof(options), options.Capacity, "Capacity must be 1 to 1,048,576 frames.");
        if (options.FrameTime == default(BvhFrameTime))
            throw new ArgumentException("FrameTime must be more than 0, or null.", nameof(options));

        return (BvhExportOptions)options.MemberwiseClone();
    }
}
