using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>A source that repeats a finite source forever.</summary>
/// <remarks>
/// Unless the source ends as it begins, the body jumps between the last frame and the first. Thread safety is that of the repeated source.
/// </remarks>
public sealed class LoopedSource : MotionSource
{
    private readonly MotionSource _source;
    private readonly long _count;

    /// <summary>Creates a source that repeats another source.</summary>
    /// <param name="source">The source to repeat. It must have at least one frame and an end.</param>
    /// <exception cref="ArgumentException">The source has no frames or no end.</exception>
    public LoopedSource(MotionSource source)
    {
        ArgumentNullException.ThrowIfNull(source);
        if (source.FrameCount is not > 0)
            throw new ArgumentException("The source must have at least one frame and an end.", nameof(source));

        _source = source;
        _count = source.FrameCount.Value;
    }

    /// <inheritdoc/>
    public override double FrameRate => _source.FrameRate;

    /// <summary>Always null, because the source never ends.</summary>
    public override long? FrameCount => null;

    /// <inheritdoc/>
    public override bool HasDisplacement => _source.HasDisplacement;

    /// <inheritdoc/>
    public override SkeletonVariant Variant => _source.Variant;

    /// <inheritdoc/>
    public override void GetPose(long frame, Span<BoneTransform> pose) => _source.GetPose(frame % _count, pose);

    /// <inheritdoc/>
    public override FootContacts GetFootContacts(long frame) => _source.GetFootContacts(frame % _count);

    /// <inheritdoc/>
    public override void GetBody(Span<Vector3> offsets, Span<Vector3> endSites) => _source.GetBody(offsets, endSites);

    /// <inheritdoc/>
    public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values) =>
        _source.WriteValues(frame % _count, layout, order, values);
}
