using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Convert;

/// <summary>A part of a take, at its own rate or another one.</summary>
/// <remarks>A frame at the time of a frame of the take has the same values. Other frames are interpolated between two neighbours.</remarks>
internal sealed class TakePart : MotionSource
{
    // Tolerance in frames. If the rate divides that of the take or is a multiple of it, frames coincide up to rounding.
    private const double SameFrame = 1e-6;

    private readonly MotionSource _take;
    private readonly long _first;
    private readonly long _last;

    /// <summary>Creates a part of a take.</summary>
    /// <param name="take">A take that has an end.</param>
    /// <param name="part">The first frame of the part and the number of its frames.</param>
    /// <param name="rate">Frames per second; null for the rate of the take.</param>
    public TakePart(MotionSource take, (long First, long Count) part, double? rate)
    {
        _take = take;
        (_first, long count) = part;
        _last = _first + count - 1;
        FrameRate = rate ?? take.FrameRate;
        FrameCount = rate is null ? count : (long)Math.Floor(((count - 1) / take.FrameRate * FrameRate) + SameFrame) + 1;
    }

    public override double FrameRate { get; }

    public override long? FrameCount { get; }

    public override bool HasDisplacement => _take.HasDisplacement;

    public override SkeletonVariant Variant => _take.Variant;

    public override void GetBody(Span<Vector3> offsets, Span<Vector3> endSites) => _take.GetBody(offsets, endSites);

    public override FootContacts GetFootContacts(long frame)
    {
        (long before, float part) = Find(frame);
        return _take.GetFootContacts(part < 0.5f ? before : before + 1);
    }

    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        (long before, float part) = Find(frame);
        _take.GetPose(before, pose);
        if (part == 0)
            return;

        Span<BoneTransform> after = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        _take.GetPose(before + 1, after);
        PoseInterpolation.Linear(pose[..after.Length], after, part, pose);
    }

    public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values)
    {
        (long before, float part) = Find(frame);
        if (part == 0)
            _take.WriteValues(before, layout, order, values);
        else
            base.WriteValues(frame, layout, order, values);
    }

    // Finds the take's frame at or before a frame of the part, and the distance to it as a part of a frame.
    private (long Before, float Part) Find(long frame)
    {
        double place = frame * (_take.FrameRate / FrameRate);
        long before = (long)Math.Floor(place + SameFrame);
        float part = (float)(place - before);
        return _first + before >= _last ? (_last, 0) : (_first + before, part < SameFrame ? 0 : part);
    }
}
