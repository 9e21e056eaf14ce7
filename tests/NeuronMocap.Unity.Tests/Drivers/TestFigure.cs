using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity.Tests.Drivers;

/// <summary>
/// A Humanoid with random local axes in the T-pose, a twist bone between shoulder and elbow, and a turned and scaled root. After its avatar is
/// created, it is in another pose than its rest pose.
/// </summary>
internal sealed class TestFigure
{
    private readonly Dictionary<Bone, Transform> _bones = [];

    private TestFigure(GameObject root, Animator animator) => (Root, Animator) = (root, animator);

    public GameObject Root { get; }

    public Animator Animator { get; }

    public Transform this[Bone bone] => _bones[bone];

    // Rest rotations relative to the root, in the T-pose.
    public Dictionary<Transform, Quaternion> Rest { get; } = [];

    public static TestFigure Build(string name, int seed = 1, float size = 0.8f)
    {
        var random = new System.Random(seed);
        var root = new GameObject(name);
        var figure = new TestFigure(root, root.AddComponent<Animator>());
        var transforms = new List<Transform> { root.transform };
        var human = new List<HumanBone>();
        for (int index = 0; index < HumanoidBones.Count; index++)
        {
            if (HumanoidMap.GetBone((HumanoidBone)index, SkeletonVariant.Neck1, HumanoidBoneSet.All) is not { } source || !figure._bones.TryAdd(source, null!))
                continue;

            human.Add(new HumanBone { humanName = HumanoidBones.GetName((HumanoidBone)index), boneName = $"{name}_{source}", limit = new HumanLimit { useDefaultValues = true } });
        }

        // World positions of the T-pose, mirrored and at another size. Rotations are random.
        var world = new BoneTransform[BoneHierarchy.BoneCount];
        SkeletonBody.GetDefault().CopyRestPose(world);
        ForwardKinematics.ToWorld(world, world);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            if (!figure._bones.ContainsKey(bone))
                continue;

            Transform above = figure.ParentOf(bone);
            if (bone == Bone.LeftForeArm)
                above = figure.Add($"{name}_Twist", above, above.position + new Vector3(-0.05f, 0, 0), random, transforms);

            figure._bones[bone] = figure.Add($"{name}_{bone}", above, world[(int)bone].Position.ToUnityPosition() * size, random, transforms);
        }

        figure.Animator.avatar = AvatarBuilder.BuildHumanAvatar(root, Describe(human, transforms));
        Assert.True(figure.Animator.avatar.isHuman);
        foreach (Transform item in transforms.Skip(2))
            item.localRotation = RandomRotation(random);

        root.transform.SetPositionAndRotation(new Vector3(3, 0.5f, -2), Quaternion.Euler(0, 130, 0));
        root.transform.localScale = new Vector3(1.5f, 1.5f, 1.5f);
        return figure;
    }

    public HumanoidDriver Drive(MocapSource? source)
    {
        HumanoidDriver driver = Root.AddComponent<HumanoidDriver>();
        driver.Source = source;
        return driver;
    }

    /// <summary>
    /// Returns the turn of a bone away from its rest rotation, relative to the root. It equals the world turn of the performer's bone.
    /// </summary>
    public Quaternion Turn(Bone bone) =>
        Quaternion.Inverse(Root.transform.rotation) * this[bone].rotation * Quaternion.Inverse(Rest[this[bone]]);

    private static HumanDescription Describe(List<HumanBone> human, List<Transform> transforms) => new()
    {
        human = [.. human],
        skeleton = [.. transforms.Select(static item => new SkeletonBone
        {
            name = item.name, position = item.localPosition, rotation = item.localRotation, scale = item.localScale,
        })],
        upperArmTwist = 0.5f,
        lowerArmTwist = 0.5f,
        upperLegTwist = 0.5f,
        lowerLegTwist = 0.5f,
        armStretch = 0.05f,
        legStretch = 0.05f,
    };

    private static Quaternion RandomRotation(System.Random random) =>
        Quaternion.Euler((float)random.NextDouble() * 360, (float)random.NextDouble() * 360, (float)random.NextDouble() * 360);

    private Transform ParentOf(Bone bone)
    {
        for (Bone? above = BoneHierarchy.GetParent(bone); above is { } parent; above = BoneHierarchy.GetParent(parent))
        {
            if (_bones.TryGetValue(parent, out Transform? transform) && transform)
                return transform;
        }

        return Root.transform;
    }

    private Transform Add(string name, Transform parent, Vector3 position, System.Random random, List<Transform> transforms)
    {
        Transform added = new GameObject(name).transform;
        added.SetParent(parent, worldPositionStays: false);
        added.SetPositionAndRotation(position, RandomRotation(random));
        Rest[added] = added.rotation;
        transforms.Add(added);
        return added;
    }
}
