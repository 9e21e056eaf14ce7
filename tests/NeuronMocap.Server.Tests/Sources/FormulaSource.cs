using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Tests.Sources;

// A body in rest pose whose bones move by a formula of the test. It fails a test that asks for a frame outside the performance.
internal sealed class FormulaSource(double frameRate, long? frameCount, FormulaSource.Formula formula) : MotionSource
{
    public delegate void Formula(long frame, Span<BoneTransform> pose);

    public override double FrameRate => frameRate;

    public override long? FrameCount => frameCount;

    public override bool HasDisplacement => true;

    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        RequireFrame(frame);
        foreach (Bone bone in BoneHierarchy.Bones)
            pose[(int)bone] = new BoneTransform(DefaultOffsets.Get(bone), Quaternion.Identity);

        formula(frame, pose);
    }

    // The left foot has contact on even frames, the right foot on every third.
    public override FootContacts GetFootContacts(long frame)
    {
        RequireFrame(frame);
        return new FootContacts(frame % 2 == 0, frame % 3 == 0);
    }

    private void RequireFrame(long frame)
    {
        if (frame < 0 || frame >= (frameCount ?? long.MaxValue))
            throw new ArgumentOutOfRangeException(nameof(frame), frame, "Outside the performance.");
    }
}
