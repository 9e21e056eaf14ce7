using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Server;

// Values that identify frame, layout, order, index and avatar, over all bit patterns, including NaN and negative zero.
internal sealed class TestSource(int seed = 0, long? frameCount = null) : MotionSource
{
    private readonly int _seed = seed;

    public override double FrameRate => 60;

    public override long? FrameCount { get; } = frameCount;

    public override bool HasDisplacement => true;

    public override void GetPose(long frame, Span<BoneTransform> pose) => pose.Fill(BoneTransform.Identity);

    public override FootContacts GetFootContacts(long frame) => new(true, false);

    public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values)
    {
        Assert.Equal(layout.ValueCount, values.Length);
        Fill(values, Mix(_seed, (int)frame, layout.ValueCount, (int)order));
    }

    // As a CalculationProvider, for avatars that are not turned.
    public static void WriteCalculation(MotionSource source, long frame, Span<float> values)
    {
        Assert.Equal(946, values.Length);
        Fill(values, Mix(((TestSource)source)._seed, (int)frame, values.Length, -1));
    }

    private static uint Mix(int a, int b, int c, int d) =>
        unchecked((((((((uint)a * 31) + (uint)b) * 2_654_435_761) + (uint)c) * 31) + (uint)d) * 2_246_822_519);

    private static void Fill(Span<float> values, uint state)
    {
        for (int i = 0; i < values.Length; i++)
        {
            state = (state * 1_664_525) + 1_013_904_223;
            values[i] = BitConverter.UInt32BitsToSingle(state);
        }
    }
}

// A performance that fails in one frame.
internal sealed class FailingSource(long badFrame, double frameRate = 1000) : MotionSource
{
    public override double FrameRate { get; } = frameRate;

    public override long? FrameCount => null;

    public override bool HasDisplacement => false;

    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        if (frame == badFrame)
            throw new InvalidDataException("The source is broken.");

        pose.Fill(BoneTransform.Identity);
    }

    public override FootContacts GetFootContacts(long frame) => new(false, false);
}
