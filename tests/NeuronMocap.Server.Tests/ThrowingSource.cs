using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Tests;

// A performance with a member that fails from a moment chosen by the test. The members are user code, whatever thread calls them.
internal sealed class ThrowingSource(string member, Exception exception) : MotionSource
{
    private readonly SyntheticSource _actor = new();

    public bool IsBroken { get; set; }

    public override double FrameRate => Guard(nameof(FrameRate), _actor.FrameRate);

    public override long? FrameCount => Guard(nameof(FrameCount), _actor.FrameCount);

    public override bool HasDisplacement => Guard(nameof(HasDisplacement), _actor.HasDisplacement);

    public override SkeletonVariant Variant => Guard(nameof(Variant), _actor.Variant);

    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        Guard(nameof(GetPose), 0);
        _actor.GetPose(frame, pose);
    }

    public override FootContacts GetFootContacts(long frame) => Guard(nameof(GetFootContacts), _actor.GetFootContacts(frame));

    public override void GetBody(Span<Vector3> offsets, Span<Vector3> endSites)
    {
        Guard(nameof(GetBody), 0);
        _actor.GetBody(offsets, endSites);
    }

    public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values)
    {
        Guard(nameof(WriteValues), 0);
        _actor.WriteValues(frame, layout, order, values);
    }

    private T Guard<T>(string name, T value) => IsBroken && name == member ? throw exception : value;
}
