using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity.Tests.Drivers;

/// <summary>Rigs without an avatar: the stream's own skeleton, with default sizes.</summary>
internal static class GenericRig
{
    public static GameObject Build(string prefix, out Dictionary<Bone, Transform> bones)
    {
        var root = new GameObject("Rig");
        bones = [];
        SkeletonBody body = SkeletonBody.GetDefault();
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Transform added = new GameObject(prefix + BoneHierarchy.GetName(bone)).transform;
            added.SetParent(BoneHierarchy.GetParent(bone) is { } parent ? bones[parent] : root.transform, worldPositionStays: false);
            added.localPosition = body.GetOffset(bone).ToUnityPosition();
            bones.Add(bone, added);
        }

        return root;
    }

    /// <summary>Builds a rig whose first child is not its hips, but a mesh, as in many models.</summary>
    public static GameObject BuildAfterMesh(out Dictionary<Bone, Transform> bones)
    {
        GameObject rig = Build("", out bones);
        Transform mesh = new GameObject("Mesh").transform;
        bones[Bone.Hips].SetParent(mesh);
        mesh.SetParent(rig.transform);
        bones[Bone.Hips].SetParent(rig.transform);
        return rig;
    }

    /// <summary>Builds a rig that stands with its arms at 45 degrees, with a skin that is bound in this pose.</summary>
    public static GameObject BuildInAPose(out Dictionary<Bone, Transform> bones)
    {
        GameObject rig = Build("", out bones);
        LowerArms(bones, 45);
        BindSkin(rig, bones);
        return rig;
    }

    public static void LowerArms(Dictionary<Bone, Transform> bones, float degrees)
    {
        bones[Bone.LeftArm].localRotation = Quaternion.Euler(0, 0, degrees);
        bones[Bone.RightArm].localRotation = Quaternion.Euler(0, 0, -degrees);
    }

    /// <summary>Adds a skin that is bound in the current pose.</summary>
    public static void BindSkin(GameObject rig, Dictionary<Bone, Transform> bones)
    {
        SkinnedMeshRenderer skin = rig.AddComponent<SkinnedMeshRenderer>();
        Transform[] all = [.. bones.Values];
        skin.bones = all;
        skin.sharedMesh = new Mesh { bindposes = [.. all.Select(bone => bone.worldToLocalMatrix * rig.transform.localToWorldMatrix)] };
    }
}
