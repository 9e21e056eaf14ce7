namespace UnityEngine.StandIn;

/// <summary>
/// The requirements for an avatar. Unity rejects some faults with a message and silently creates a wrong avatar for others. Here all faults are
/// rejected, so that a wrong description fails.
/// </summary>
internal static class AvatarRules
{
    // In degrees. An arm of a T-pose may hang by this much before Unity's own check reports a wrong pose.
    private const float Tolerance = 15;

    public static List<string> Find(Transform root, HumanDescription description)
    {
        var faults = new List<string>();
        if (description.human is null || description.skeleton is null || description.skeleton.Length == 0)
            return ["the description lists no bones"];

        if (root.Parent is not null)
            faults.Add("the root has a parent");

        if (description.skeleton[0].name != root.name)
            faults.Add($"the first skeleton bone is '{description.skeleton[0].name}', not the root '{root.name}'");

        var transforms = new Dictionary<string, Transform>();
        AddAll(root, transforms, faults);
        var skeleton = new HashSet<string>();
        foreach (SkeletonBone bone in description.skeleton)
            CheckSkeletonBone(bone, root, transforms, skeleton, faults);

        Dictionary<HumanBodyBones, Transform> mapped = Map(description.human, transforms, skeleton, faults);
        CheckMapping(mapped, root, faults);
        if (faults.Count == 0)
            CheckPose(mapped, root, faults);

        if (description.upperArmTwist == 0 && description.lowerArmTwist == 0 && description.armStretch == 0 && description.legStretch == 0)
            faults.Add("twist and stretch are left at nought, which makes stiff limbs");

        return faults;
    }

    private static void AddAll(Transform item, Dictionary<string, Transform> transforms, List<string> faults)
    {
        if (!transforms.TryAdd(item.name, item))
            faults.Add($"two transforms are called '{item.name}'");

        foreach (Transform child in item.Children)
            AddAll(child, transforms, faults);
    }

    private static void CheckSkeletonBone(
        SkeletonBone bone, Transform root, Dictionary<string, Transform> transforms, HashSet<string> skeleton, List<string> faults)
    {
        if (!skeleton.Add(bone.name))
            faults.Add($"the skeleton lists '{bone.name}' twice");

        if (!transforms.TryGetValue(bone.name, out Transform? transform))
        {
            faults.Add($"transform '{bone.name}' for skeleton bone not found");
            return;
        }

        if (bone.scale == Vector3.zero || Mathf.Abs(Quaternion.Dot(bone.rotation, bone.rotation) - 1) > 1e-3f)
            faults.Add($"'{bone.name}' has no scale or no unit rotation");

        // Unity also reads the live hierarchy. Both must agree.
        if (transform != root && ((transform.localPosition - bone.position).magnitude > 1e-3f || Quaternion.Angle(transform.localRotation, bone.rotation) > 0.5f))
            faults.Add($"'{bone.name}' does not stand as the skeleton says");
    }

    private static Dictionary<HumanBodyBones, Transform> Map(
        HumanBone[] human, Dictionary<string, Transform> transforms, HashSet<string> skeleton, List<string> faults)
    {
        var mapped = new Dictionary<HumanBodyBones, Transform>();
        foreach (HumanBone bone in human)
        {
            int index = Array.IndexOf(HumanTrait.BoneName, bone.humanName);
            if (index < 0)
                faults.Add($"'{bone.humanName}' is not a human bone");
            else if (!transforms.TryGetValue(bone.boneName, out Transform? transform))
                faults.Add($"transform '{bone.boneName}' for human bone '{bone.humanName}' not found");
            else if (!mapped.TryAdd((HumanBodyBones)index, transform))
                faults.Add($"'{bone.humanName}' is mapped twice");
            else if (mapped.Count(pair => pair.Value == transform) > 1)
                faults.Add($"'{bone.boneName}' is mapped to two human bones");
            else
                CheckListed(transform, skeleton, faults);
        }

        for (int bone = 0; bone < HumanTrait.BoneCount; bone++)
        {
            if (HumanTrait.RequiredBone(bone) && !mapped.ContainsKey((HumanBodyBones)bone))
                faults.Add($"required human bone '{HumanTrait.BoneName[bone]}' not found");
        }

        return mapped;
    }

    private static void CheckListed(Transform bone, HashSet<string> skeleton, List<string> faults)
    {
        for (Transform? item = bone; item is not null; item = item.Parent)
        {
            if (!skeleton.Contains(item.name))
                faults.Add($"'{item.name}', at or above the mapped '{bone.name}', is not in the skeleton");
        }
    }

    private static void CheckMapping(Dictionary<HumanBodyBones, Transform> mapped, Transform root, List<string> faults)
    {
        foreach ((HumanBodyBones bone, Transform transform) in mapped)
        {
            int parent = HumanTrait.GetParentBone((int)bone);
            while (parent >= 0 && !mapped.ContainsKey((HumanBodyBones)parent))
                parent = HumanTrait.GetParentBone(parent);

            if (parent >= 0 && (transform == mapped[(HumanBodyBones)parent] || !transform.IsChildOf(mapped[(HumanBodyBones)parent])))
                faults.Add($"'{transform.name}' ({bone}) is not below '{mapped[(HumanBodyBones)parent].name}' ({(HumanBodyBones)parent})");

            if (transform == root)
                faults.Add($"the root itself is mapped to {bone}");
        }
    }

    // Arms to the sides, legs down, spine up, and left on the left side of a figure that faces +z.
    private static void CheckPose(Dictionary<HumanBodyBones, Transform> mapped, Transform root, List<string> faults)
    {
        Along(HumanBodyBones.LeftUpperArm, HumanBodyBones.LeftHand, Vector3.left);
        Along(HumanBodyBones.RightUpperArm, HumanBodyBones.RightHand, Vector3.right);
        Along(HumanBodyBones.LeftUpperLeg, HumanBodyBones.LeftFoot, Vector3.down);
        Along(HumanBodyBones.RightUpperLeg, HumanBodyBones.RightFoot, Vector3.down);
        Along(HumanBodyBones.Hips, HumanBodyBones.Head, Vector3.up);

        void Along(HumanBodyBones from, HumanBodyBones to, Vector3 direction)
        {
            Vector3 line = root.InverseTransformPoint(mapped[to].position) - root.InverseTransformPoint(mapped[from].position);
            float angle = Vector3.Angle(line, direction);
            if (angle > Tolerance)
                faults.Add($"not in T-pose: from {from} to {to} is {angle:F0} degrees off");
        }
    }
}
