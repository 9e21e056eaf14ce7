namespace NeuronMocap.Bvh;

/// <summary>Options for reading a BVH file. The values are copied when used; later changes have no effect.</summary>
public sealed class BvhReadOptions
{
    /// <summary>
    /// Whether to throw a <see cref="BvhFormatException"/> with the position of the first defect, instead of repairing it
    /// (<see cref="BvhRepair"/>). Common variations are not defects: the case of keywords, white space, line ends, a byte order mark, or a missing
    /// MOTION section.
    /// </summary>
    public bool Strict { get; set; }

    /// <summary>
    /// Receives the number of bytes read from a stream or file; may be null. It is called on the reading thread, after every piece of at most about
    /// 128 KiB. An exception from it ends the reading and reaches the caller.
    /// </summary>
    public IProgress<long>? Progress { get; set; }
}
