using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

// One frame in the buffer. The first three are the writer's, the last two the sampler's.
internal sealed class PoseSlot
{
    public readonly BoneTransform[] Pose = new BoneTransform[BoneHierarchy.BoneCount];

    public double Arrival;
    public uint? Index;

    // When the frame was, on the even clock of the sender that its arrivals show.
    public double Time;

    // Not needed any more; it goes back to the writer once all before it do.
    public bool IsDone;
}
