using NeuronMocap.Skeleton;

namespace NeuronMocap.Csv;

/// <summary>The units and axes of a table of poses, and what its comment lines say about the source. The writer reads them when it is created.</summary>
public sealed class PoseCsvOptions
{
    /// <summary>The axes. The default is Y up.</summary>
    public UpAxis UpAxis { get; set; }

    /// <summary>The unit of positions. The default is metres.</summary>
    public LengthUnit Unit { get; set; }

    /// <summary>The names of the bones and the parent of the shoulders. The default is <see cref="SkeletonVariant.Neck1"/>.</summary>
    public SkeletonVariant Variant { get; set; }

    /// <summary>The source of the poses, such as the name of a file. Null for no comment.</summary>
    public string? Source { get; set; }

    /// <summary>The rotation order of the source's angles. Quaternions have none, so it is only a comment. Null for no comment.</summary>
    public RotationOrder? RotationOrder { get; set; }

    /// <summary>Frames per second of each avatar, for a comment. Null if it is unknown.</summary>
    public double? FrameRate { get; set; }

    /// <summary>The moment at time zero, for a comment. Null if it is unknown.</summary>
    public DateTimeOffset? StartTime { get; set; }

    /// <summary>The names of the avatars by their numbers, for comments. The default is empty.</summary>
    public IReadOnlyDictionary<int, string> AvatarNames { get; set; } = new Dictionary<int, string>();
}
