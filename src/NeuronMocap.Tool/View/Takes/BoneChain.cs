using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Finds the place and angle of one bone in a compact pose. Not thread-safe.</summary>
internal sealed class BoneChain
{
    private readonly SkeletonBody _body;
    private readonly int[] _chain;
    private readonly BoneTransform[] _local = new BoneTransform[BoneHierarchy.BoneCount];

    public BoneChain(SkeletonBody body, Bone bone)
    {
        _body = body;
        var chain = new List<int>();
        for (Bone? link = bone; link is { } known; link = BoneHierarchy.GetParent(known, body.Variant))
            chain.Insert(0, (int)known);

        _chain = [.. chain];
    }

    /// <summary>Measures a pose.</summary>
    /// <returns>Its time in microseconds, the position in centimetres and the angle in degrees.</returns>
    public (long Time, Vector3 Place, float Angle) Measure(ReadOnlySpan<byte> pose)
    {
        CompactPose.TryDecode(pose, out CompactPoseHeader header, _local, _body);
        BoneTransform world = _local[_chain[0]];
        foreach (int bone in _chain.AsSpan(1))
            world = world.Apply(_local[bone]);

        long time = (header.Time.UtcTicks - DateTimeOffset.UnixEpoch.UtcTicks) / TimeSpan.TicksPerMicrosecond;
        return (time, world.Position, PerformerWriter.AngleOf(_local[_chain[^1]].Rotation));
    }
}
