using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>
/// Options for exporting frames to BVH files: <see cref="NeuronReader.ExportBvh"/>. The values are copied when used; later changes have no effect.
/// </summary>
public sealed class BvhExportOptions
{
    /// <summary>Default maximum number of queued frames: 34 s of one avatar at 120 Hz, 6 MB.</summary>
    public const int DefaultCapacity = 4096;

    /// <summary>The number of the avatar to export. Null, the default, selects the avatar of the first frame.</summary>
    public int? AvatarIndex { get; set; }

    /// <summary>
    /// Whether every avatar has its own file, up to 64. For "take.bvh", the files are "take-avatar0.bvh", "take-avatar1.bvh" and so on. Over UDP,
    /// those of the second sender are named like "take-sender1-avatar0.bvh".
    /// </summary>
    public bool FilePerAvatar { get; set; }

    /// <summary>Whether existing files are replaced. By default, an existing file is an error.</summary>
    public bool Overwrite { get; set; }

    /// <summary>
    /// The body of the actor. Null, the default, finds it automatically.
    /// </summary>
    /// <remarks>
    /// The OFFSETs come from the first of these sources that is available:
    /// <list type="number">
    /// <item>the positions of a stream with displacement;</item>
    /// <item>this body;</item>
    /// <item>the BVH header from the command channel (<see cref="NeuronReaderOptions.CommandPort"/>);</item>
    /// <item>the bone sizes from the command channel;</item>
    /// <item>the default body of the manual's Appendix B.</item>
    /// </list>
    /// </remarks>
    public SkeletonBody? Body { get; set; }

    /// <summary>
    /// How long the first row of an avatar waits for answers from the command channel. The default is 2 s. The wait is needed because the hierarchy
    /// precedes the rows; frames stay in the queue meanwhile. Without <see cref="NeuronReaderOptions.CommandPort"/>, there is no wait.
    /// </summary>
    public TimeSpan HeaderTimeout { get; set; } = TimeSpan.FromSeconds(2);

    /// <summary>Time from one frame to the next. Null, the default, measures it: see <see cref="BvhTakeOptions.FrameTime"/>.</summary>
    public BvhFrameTime? FrameTime { get; set; }

    /// <summary>Specifies how lost frames are written. The default repeats the previous row.</summary>
    public BvhGapHandling GapHandling { get; set; }

    /// <summary>The text layout. The default is that of Axis Neuron.</summary>
    public BvhTextFormat TextFormat { get; set; } = BvhTextFormat.AxisNeuron;

    /// <summary>Maximum number of frames that can wait for the disk, 1 to 1,048,576: <see cref="FrameQueue.Capacity"/>.</summary>
    public int Capacity { get; set; } = DefaultCapacity;

    /// <summary>
    /// Number of received frames, of all exported avatars together, after which the export ends; at least 1. Null, the default, means no limit.
    /// </summary>
    public long? MaxFrames { get; set; }

    internal static BvhExportOptions CopyChecked(BvhExportOptions? options)
    {
        options ??= new BvhExportOptions();
        if (options.HeaderTimeout < TimeSpan.Zero || options.HeaderTimeout > TimeSpan.FromMinutes(5))
            throw new ArgumentOutOfRangeException(nameof(options), options.HeaderTimeout, $"HeaderTimeout is {options.HeaderTimeout}; it must be 0 to 5 minutes.");
        if (options.Capacity is < 1 or > 1 << 20)
            throw new ArgumentOutOfRangeException(nameof(options), options.Capacity, $"Capacity is {options.Capacity}; it must be 1 to 1,048,576.");
        if (options.MaxFrames < 1)
            throw new ArgumentOutOfRangeException(nameof(options), options.MaxFrames, $"MaxFrames is {options.MaxFrames}; it must be at least 1, or null.");
        if (options.FrameTime == default(BvhFrameTime))
            throw new ArgumentException("FrameTime is 0; it must be more than 0, or null.", nameof(options));

        return (BvhExportOptions)options.MemberwiseClone();
    }
}
