using System.Globalization;
using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Osc;

/// <summary>Writes poses as plain OSC: a message for each bone, and one at the end of the frame. One thread uses it.</summary>
/// <param name="poses">All avatars of the destination.</param>
/// <param name="prefix">The start of all addresses, such as "/neuron".</param>
/// <param name="space">What the transforms are relative to.</param>
/// <param name="scale">The factor of all positions.</param>
/// <param name="start">The instant that counts as 0, in ticks of the stopwatch.</param>
internal sealed class OscPoseEncoder(AvatarPoses poses, string prefix, OscSpace space, float scale, long start) : IPoseEncoder
{
    private const int TransformSize = 7 * sizeof(float);

    private readonly BoneTransform[] _sent = new BoneTransform[BoneHierarchy.BoneCount];

    public bool TryEncode(AvatarPose pose, OscBundle bundle)
    {
        if (!TryTransform(pose))
            return false;

        if (pose.Cache is not Heads heads || heads.Variant != pose.Variant)
            pose.Cache = heads = Create(pose);
        for (int bone = 0; bone < _sent.Length; bone++)
            OscHead.Write(bundle.Add(heads.Bones[bone], TransformSize), _sent[bone].Position, _sent[bone].Rotation);

        Span<byte> place = bundle.Add(heads.Frame, 2 * sizeof(int));
        OscHead.Write(place[sizeof(int)..], PoseTime.Seconds(pose.Timestamp, start));
        OscHead.Write(place, pose.FrameIndex is { } index ? unchecked((int)index) : -1);
        bundle.Flush();
        return true;
    }

    // Returns false if a number is not finite. Finite values of the stream can be too large to add or to scale.
    private bool TryTransform(AvatarPose pose)
    {
        if (space == OscSpace.World)
            ForwardKinematics.ToWorld(pose.Local, _sent, pose.Variant);
        else
            pose.Local.AsSpan().CopyTo(_sent);

        foreach (ref BoneTransform transform in _sent.AsSpan())
        {
            transform = new BoneTransform(transform.Position * scale, Quaternion.Normalize(transform.Rotation));
            if (!OscHead.CanWrite(transform.Position, transform.Rotation))
                return false;
        }

        return true;
    }

    private Heads Create(AvatarPose pose)
    {
        string name = ChooseName(pose);
        string address = $"{prefix}/{name}/";
        byte[][] bones = [.. BoneHierarchy.Bones.ToArray().Select(bone => OscHead.Of(address + BoneHierarchy.GetName(bone, pose.Variant), "fffffff"))];
        return new Heads(name, pose.Variant, bones, OscHead.Of(address + "frame", "if"));
    }

    // The name; with the number, if another avatar has the name already; with the sender, if that is not enough.
    private string ChooseName(AvatarPose pose)
    {
        string number = pose.Index.ToString(CultureInfo.InvariantCulture);
        string name = pose.Name.Length == 0 ? $"avatar{number}" : OscHead.ToPart(pose.Name);
        string[] names = [name, $"{name}-{number}", $"{name}-{number}-{pose.Sender.ToString(CultureInfo.InvariantCulture)}"];
        return Array.Find(names, free => poses.All.All(other => other == pose || !string.Equals((other.Cache as Heads)?.Name, free, StringComparison.Ordinal))) ?? names[^1];
    }

    private sealed record Heads(string Name, SkeletonVariant Variant, byte[][] Bones, byte[] Frame);
}
