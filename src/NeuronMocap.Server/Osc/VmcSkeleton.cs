using System.Numerics;
using System.Text;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Osc;

/// <summary>Converts poses of VMC to bones of the stream. One thread uses it.</summary>
/// <remarks>
/// The stream has bones that VMC lacks, such as those of the palms. They do not turn, and share the way to the next bone. Bones that a sender's model
/// lacks, such as the upper chest, do not turn. They have no length, because the next bone is placed relative to the one before them.
/// </remarks>
internal sealed class VmcSkeleton
{
    private static readonly (HumanoidBone Bone, byte[] Name, Bone Source, Bone[] Between)[] Bones = [.. CreateBones()];

    // Positions and rotations in Unity's axes and metres; null for what was not received.
    private readonly BoneTransform?[] _received = new BoneTransform?[HumanoidBones.Count];
    private BoneTransform _root = BoneTransform.Identity;

    /// <summary>Whether a bone has arrived since the last pose.</summary>
    public bool HasChanged { get; private set; }

    /// <summary>Whether the hips have arrived since the last pose.</summary>
    public bool HasHips { get; private set; }

    public void SetRoot(BoneTransform root) => _root = root;

    /// <summary>Takes a bone. Bones that the stream lacks, such as the eyes, are ignored.</summary>
    public void Set(ReadOnlySpan<byte> name, BoneTransform local)
    {
        foreach (ref readonly var bone in Bones.AsSpan())
        {
            if (!name.SequenceEqual(bone.Name))
                continue;

            _received[(int)bone.Bone] = local;
            HasHips |= bone.Bone == HumanoidBone.Hips;
            HasChanged = true;
            return;
        }
    }

    /// <summary>Writes the pose as 59 transforms relative to the parent, in the axes of the library; the hips in the world.</summary>
    public void TakePose(Span<BoneTransform> pose)
    {
        (HasChanged, HasHips) = (false, false);
        SkeletonBody.GetDefault().CopyRestPose(pose);
        foreach (ref readonly var bone in Bones.AsSpan())
        {
            if (_received[(int)bone.Bone] is not { } local)
            {
                if (IsAboveReceived(bone.Bone))
                    Place(pose, bone.Source, bone.Between, BoneTransform.Identity);

                continue;
            }

            if (bone.Bone == HumanoidBone.Hips)
                local = _root.Apply(local);

            // Some senders leave the positions out.
            Vector3 position = UnityAxes.FromUnityPosition(local.Position) / (bone.Between.Length + 1);
            var transform = new BoneTransform(position, UnityAxes.FromUnityRotation(local.Rotation));
            if (bone.Bone == HumanoidBone.Hips || local.Position != Vector3.Zero)
                Place(pose, bone.Source, bone.Between, transform);
            else
                pose[(int)bone.Source] = transform with { Position = pose[(int)bone.Source].Position };
        }
    }

    // The bones in between share the way and do not turn.
    private static void Place(Span<BoneTransform> pose, Bone bone, Bone[] between, BoneTransform transform)
    {
        pose[(int)bone] = transform;
        foreach (Bone other in between)
            pose[(int)other] = transform with { Rotation = Quaternion.Identity };
    }

    // Only these bones are optional and have required bones below them.
    private bool IsAboveReceived(HumanoidBone bone) => bone switch
    {
        HumanoidBone.Spine or HumanoidBone.Chest or HumanoidBone.UpperChest or HumanoidBone.Neck => IsPlaced(HumanoidBone.Head),
        HumanoidBone.LeftShoulder => IsPlaced(HumanoidBone.LeftUpperArm),
        HumanoidBone.RightShoulder => IsPlaced(HumanoidBone.RightUpperArm),
        _ => false,
    };

    private bool IsPlaced(HumanoidBone bone) => _received[(int)bone] is { } local && local.Position != Vector3.Zero;

    private static IEnumerable<(HumanoidBone Bone, byte[] Name, Bone Source, Bone[] Between)> CreateBones()
    {
        for (var bone = HumanoidBone.Hips; (int)bone < HumanoidBones.Count; bone++)
        {
            if (HumanoidMap.GetBone(bone, SkeletonVariant.Neck1, HumanoidBoneSet.All) is not { } source)
                continue;

            Bone? above = HumanoidBones.GetParent(bone) is { } parent ? HumanoidMap.GetBone(parent, SkeletonVariant.Neck1, HumanoidBoneSet.All) : null;
            List<Bone> between = [];
            for (Bone? next = BoneHierarchy.GetParent(source); next is { } found && found != above; next = BoneHierarchy.GetParent(found))
                between.Add(found);

            yield return (bone, Encoding.ASCII.GetBytes(bone.ToString()), source, [.. between]);
        }
    }
}
