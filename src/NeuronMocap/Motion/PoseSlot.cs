using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

// One frame in the buffer. The first four fields belong to the writer, the last two to the sampler.
internal sealed class PoseSlot
{
    public readonly BoneTransform[] Pose = new BoneTransform[BoneHierarchy.BoneCount];

    public double Arrival;
    public uint? Index;
    public long Tag;

    // The time of the frame on the sender's even clock.
    public double Time;

    // The slot is no longer needed. It returns to the writer after all slots before it.
    public bool IsDone;
}
