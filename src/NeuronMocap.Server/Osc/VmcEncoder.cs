using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Osc;

/// <summary>Writes poses as messages of the Virtual Motion Capture protocol. One thread uses it.</summary>
/// <param name="scale">The factor of all positions.</param>
/// <param name="movesRoot">Whether the root moves over the ground instead of the hips.</param>
/// <param name="start">The instant that counts as 0, in ticks of the stopwatch.</param>
internal sealed class VmcEncoder(float scale, bool movesRoot, long start) : IPoseEncoder
{
    private const int TransformSize = 7 * sizeof(float);

    private static readonly byte[] Root = OscHead.Of("/VMC/Ext/Root/Pos", "sfffffff", "root");
    private static readonly byte[] Loaded = OscHead.Of("/VMC/Ext/OK", "i");
    private static readonly byte[] Time = OscHead.Of("/VMC/Ext/T", "f");

    // By the variant of the stream.
    private readonly (VmcRig Rig, byte[][] Heads)?[] _rigs = new (VmcRig, byte[][])?[2];

    public bool TryEncode(AvatarPose pose, OscBundle bundle)
    {
        (VmcRig rig, byte[][] heads) = _rigs[pose.Variant == SkeletonVariant.Spine3 ? 1 : 0] ??= Create(pose.Variant);
        if (!rig.TryPose(pose.Local) || !CanScale(rig))
            return false;

        Vector3 hips = rig.Positions[0] * scale;
        Vector3 root = movesRoot ? new Vector3(hips.X, 0, hips.Z) : Vector3.Zero;
        OscHead.Write(bundle.Add(Root, TransformSize), root, Quaternion.Identity);
        OscHead.Write(bundle.Add(heads[0], TransformSize), hips - root, rig.Rotations[0]);
        for (int node = 1; node < heads.Length; node++)
            OscHead.Write(bundle.Add(heads[node], TransformSize), rig.Positions[node] * scale, rig.Rotations[node]);

        // Receivers show a frame when they get one of these.
        OscHead.Write(bundle.Add(Loaded, sizeof(int)), 1);
        OscHead.Write(bundle.Add(Time, sizeof(float)), PoseTime.Seconds(pose.Timestamp, start));
        bundle.Flush();
        return true;
    }

    private bool CanScale(VmcRig rig)
    {
        for (int node = 0; node < rig.Positions.Length; node++)
        {
            if (!OscHead.CanWrite(rig.Positions[node] * scale, rig.Rotations[node]))
                return false;
        }

        return true;
    }

    private static (VmcRig Rig, byte[][] Heads) Create(SkeletonVariant variant)
    {
        var rig = new VmcRig(variant);
        return (rig, [.. rig.Bones.Select(static bone => OscHead.Of("/VMC/Ext/Bone/Pos", "sfffffff", bone.ToString()))]);
    }
}
