using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>
/// A finite performance that starts again when it is over, and so never ends. Between the last frame and the first the body jumps, unless
/// the performance ends as it begins. As safe to call from several threads as the performance itself.
/// </summary>
public sealed class LoopedSource : MotionSource
{
    private readonly MotionSource _source;
    private readonly long _count;

    /// <summary>Makes a source of another one.</summary>
    /// <param name="source">What to repeat; at least one frame, and not endless.</param>
    /// <exception cref="ArgumentException">The source has no frames or no end.</exception>
    public LoopedSource(MotionSource source)
    {
        if (source.FrameCount is not > 0)
            throw new ArgumentException("Only a performance that has frames and an end can be repeated.", nameof(source));

        _source = source;
        _count = source.FrameCount.Value;
    }

    /// <inheritdoc/>
    public override double FrameRate => _source.FrameRate;

    /// <summary>Always null: it never ends.</summary>
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
