namespace NeuronMocap.Bvh;

/// <summary>How a BVH file is read. Immutable; thread-safe.</summary>
public sealed class BvhReadOptions
{
    /// <summary>
    /// Whether the first thing that is wrong is a <see cref="BvhFormatException"/> with its place: whatever would be a <see cref="BvhRepair"/> else.
    /// What is usual though not uniform is not wrong: the case of keywords, white space, line ends, a byte order mark, no MOTION at all.
    /// </summary>
    public bool Strict { get; init; }

    /// <summary>
    /// Told how many bytes of a stream or file have been read, on the reading thread, after every piece of at most about 128 KiB; null for nobody. An
    /// exception of it ends the reading and reaches the caller.
    /// </summary>
    public IProgress<long>? Progress { get; init; }
}
