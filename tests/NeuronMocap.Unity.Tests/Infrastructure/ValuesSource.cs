using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity.Tests.Infrastructure;

/// <summary>A performance whose packet values a test writes itself.</summary>
internal sealed class ValuesSource(Action<long, ChannelLayout, float[]> write, SkeletonBody? body = null) : MotionSource
{
    public override double FrameRate => 100;

    public override long? FrameCount => null;

    public override bool HasDisplacement => true;

    public override void GetPose(long frame, Span<BoneTransform> pose) => (body ?? SkeletonBody.GetDefault()).CopyRestPose(pose);

    public override FootContacts GetFootContacts(long frame) => new(frame % 2 == 0, false);

    public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values)
    {
        base.WriteValues(frame, layout, order, values);
        float[] copy = values[..layout.ValueCount].ToArray();
        write(frame, layout, copy);
        copy.CopyTo(values);
    }
}
