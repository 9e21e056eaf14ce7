namespace UnityEngine.StandIn;

/// <summary>The transforms below a root that an avatar maps, and their pose when it was created.</summary>
internal sealed class HumanBones
{
    private readonly Transform?[] _bones = new Transform?[(int)HumanBodyBones.LastBone];
    private readonly Quaternion[] _rest = new Quaternion[(int)HumanBodyBones.LastBone];

    public HumanBones(Avatar avatar, Transform root)
    {
        HumanDescription description = avatar.humanDescription;
        Dictionary<string, SkeletonBone> skeleton = description.skeleton.ToDictionary(static bone => bone.name);
        var found = new Dictionary<string, Transform>();
        Collect(root, found);
        foreach (HumanBone bone in description.human)
        {
            int index = Array.IndexOf(HumanTrait.BoneName, bone.humanName);
            if (index < 0 || !found.TryGetValue(bone.boneName, out _bones[index]))
                continue;

            _rest[index] = skeleton[bone.boneName].rotation;
        }

        HipsHeight = MeasureHips(description, skeleton);
    }

    /// <summary>Metres above the root in the T-pose. <see cref="Animator.humanScale"/> is derived from it.</summary>
    public float HipsHeight { get; }

    public Transform? Get(HumanBodyBones bone) => _bones[(int)bone];

    public Quaternion GetRest(HumanBodyBones bone) => _rest[(int)bone];

    private static void Collect(Transform item, Dictionary<string, Transform> found)
    {
        found.TryAdd(item.name, item);
        foreach (Transform child in item.Children)
            Collect(child, found);
    }

    private float MeasureHips(HumanDescription description, Dictionary<string, SkeletonBone> skeleton)
    {
        Vector3 place = Vector3.zero;
        Transform? item = Get(HumanBodyBones.Hips);
        for (; item is not null && item.name != description.skeleton[0].name; item = item.Parent)
        {
            if (skeleton.TryGetValue(item.name, out SkeletonBone bone))
                place = bone.position + (bone.rotation * Vector3.Scale(bone.scale, place));
        }

        return Mathf.Max(place.y, 0.01f);
    }
}
