namespace NeuronMocap.Unity.Tests.StandIn;

/// <summary>The steps to create a Humanoid, and that each possible mistake is detected.</summary>
public sealed class AvatarTests : IDisposable
{
    private static readonly (HumanBodyBones Bone, HumanBodyBones? Parent, Vector3 Offset)[] Bones =
    [
        (HumanBodyBones.Hips, null, new(0, 1, 0)),
        (HumanBodyBones.Spine, HumanBodyBones.Hips, new(0, 0.2f, 0)),
        (HumanBodyBones.Head, HumanBodyBones.Spine, new(0, 0.5f, 0)),
        (HumanBodyBones.LeftUpperArm, HumanBodyBones.Spine, new(-0.2f, 0.4f, 0)),
        (HumanBodyBones.LeftLowerArm, HumanBodyBones.LeftUpperArm, new(-0.3f, 0, 0)),
        (HumanBodyBones.LeftHand, HumanBodyBones.LeftLowerArm, new(-0.3f, 0, 0)),
        (HumanBodyBones.LeftIndexProximal, HumanBodyBones.LeftHand, new(-0.1f, 0, 0)),
        (HumanBodyBones.RightUpperArm, HumanBodyBones.Spine, new(0.2f, 0.4f, 0)),
        (HumanBodyBones.RightLowerArm, HumanBodyBones.RightUpperArm, new(0.3f, 0, 0)),
        (HumanBodyBones.RightHand, HumanBodyBones.RightLowerArm, new(0.3f, 0, 0)),
        (HumanBodyBones.LeftUpperLeg, HumanBodyBones.Hips, new(-0.1f, 0, 0)),
        (HumanBodyBones.LeftLowerLeg, HumanBodyBones.LeftUpperLeg, new(0, -0.45f, 0)),
        (HumanBodyBones.LeftFoot, HumanBodyBones.LeftLowerLeg, new(0, -0.45f, 0)),
        (HumanBodyBones.RightUpperLeg, HumanBodyBones.Hips, new(0.1f, 0, 0)),
        (HumanBodyBones.RightLowerLeg, HumanBodyBones.RightUpperLeg, new(0, -0.45f, 0)),
        (HumanBodyBones.RightFoot, HumanBodyBones.RightLowerLeg, new(0, -0.45f, 0)),
    ];

    private readonly PlayerLoop _loop = new();
    private readonly GameObject _root = new("Figure");
    private HumanDescription _description;

    public AvatarTests()
    {
        foreach ((HumanBodyBones bone, HumanBodyBones? parent, Vector3 offset) in Bones)
        {
            Transform item = new GameObject($"the {bone}").transform;
            item.SetParent(parent is { } above ? Get(above) : _root.transform, false);
            item.localPosition = offset;
        }

        _description = new HumanDescription
        {
            human = [.. Bones.Select(static item => new HumanBone { humanName = HumanTrait.BoneName[(int)item.Bone], boneName = $"the {item.Bone}" })],
            skeleton = [.. _root.GetComponentsInChildren<Transform>().Select(static item => new SkeletonBone
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
    }

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void A_right_recipe_makes_an_avatar_that_knows_its_bones()
    {
        Avatar avatar = AvatarBuilder.BuildHumanAvatar(_root, _description);
        Animator animator = _root.AddComponent<Animator>();

        Assert.Throws<InvalidOperationException>(() => animator.GetBoneTransform(HumanBodyBones.Hips));
        animator.avatar = avatar;

        Assert.True(avatar.isValid && avatar.isHuman && animator.isHuman);
        Assert.Same(Get(HumanBodyBones.LeftIndexProximal), animator.GetBoneTransform(HumanBodyBones.LeftIndexProximal));
        Assert.Null(animator.GetBoneTransform(HumanBodyBones.UpperChest));
        Assert.Throws<IndexOutOfRangeException>(() => animator.GetBoneTransform(HumanBodyBones.LastBone));
        Assert.Equal(1, animator.humanScale, 3);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void A_pose_that_was_read_can_be_set_again()
    {
        Avatar avatar = AvatarBuilder.BuildHumanAvatar(_root, _description);
        using var handler = new HumanPoseHandler(avatar, _root.transform);
        HumanPose pose = default;
        Transform arm = Get(HumanBodyBones.LeftUpperArm);
        arm.localRotation = Quaternion.Euler(20, 30, 40);
        handler.GetHumanPose(ref pose);
        Quaternion expected = arm.localRotation;
        arm.localRotation = Quaternion.identity;

        handler.SetHumanPose(ref pose);

        Assert.Equal(95, pose.muscles.Length);
        Assert.InRange(Quaternion.Angle(expected, arm.localRotation), 0, 0.1f);
    }

    [Fact]
    public void The_traits_match_Unity()
    {
        Assert.Equal(55, HumanTrait.BoneName.Length);
        Assert.Equal(95, HumanTrait.MuscleCount);
        Assert.Equal(15, HumanTrait.RequiredBoneCount);
        Assert.Equal(15, Enumerable.Range(0, 55).Count(HumanTrait.RequiredBone));
        Assert.Equal("Left Index Proximal", HumanTrait.BoneName[27]);
        Assert.Equal("LeftToes", HumanTrait.BoneName[19]);
        Assert.Equal("UpperChest", HumanTrait.BoneName[54]);
        Assert.Equal((int)HumanBodyBones.LeftHand, HumanTrait.GetParentBone((int)HumanBodyBones.LeftRingProximal));
        Assert.Equal((int)HumanBodyBones.RightLowerLeg, HumanTrait.GetParentBone((int)HumanBodyBones.RightFoot));
        Assert.Equal((int)HumanBodyBones.LeftFoot, HumanTrait.GetParentBone((int)HumanBodyBones.LeftToes));
        Assert.Equal(-1, HumanTrait.GetParentBone(0));
    }

    [Fact]
    public void The_first_skeleton_bone_is_the_root() => Refuse("not the root", () => _description.skeleton[0].name = "Other");

    [Fact]
    public void Names_are_unique() => Refuse("two transforms", () => Get(HumanBodyBones.Head).name = "the Spine");

    [Fact]
    public void Every_mapped_bone_and_its_ancestors_are_listed() =>
        Refuse("not in the skeleton", () => _description.skeleton = [.. _description.skeleton.Where(static bone => bone.name != "the LeftUpperArm")]);

    [Fact]
    public void Names_of_human_bones_are_the_traits() => Refuse("is not a human bone", () => _description.human[6].humanName = "LeftIndexProximal");

    [Fact]
    public void The_fifteen_required_bones_are_mapped() => Refuse("'Head' not found", () => _description.human = [.. _description.human.Where(static bone => bone.humanName != "Head")]);

    [Fact]
    public void A_bone_is_mapped_once() => Refuse("mapped twice", () => _description.human[6].humanName = "Head");

    [Fact]
    public void Parents_are_above_their_children() => Refuse("is not below", () => Get(HumanBodyBones.LeftHand).SetParent(Get(HumanBodyBones.Spine)));

    [Fact]
    public void The_arms_are_stretched_out() => Refuse("not in T-pose", () => Turn(HumanBodyBones.LeftUpperArm, Quaternion.Euler(0, 0, 60)));

    [Fact]
    public void It_faces_along_z() => Refuse("not in T-pose", () => Turn(HumanBodyBones.Hips, Quaternion.Euler(0, 180, 0)));

    [Fact]
    public void The_live_pose_matches_the_list() => Refuse("does not stand", () => Get(HumanBodyBones.LeftFoot).localRotation = Quaternion.Euler(10, 0, 0));

    [Fact]
    public void The_root_has_no_parent() => Refuse("has a parent", () => _root.transform.SetParent(new GameObject("above").transform));

    [Fact]
    public void Twist_and_stretch_are_set() =>
        Refuse("stiff", () => (_description.upperArmTwist, _description.lowerArmTwist, _description.armStretch, _description.legStretch) = (0, 0, 0, 0));

    private void Refuse(string reason, Action spoil)
    {
        spoil();
        Avatar avatar = AvatarBuilder.BuildHumanAvatar(_root, _description);

        Assert.False(avatar.isValid);
        Assert.Contains(ConsoleLog.Problems, entry => entry.Message.Contains(reason, StringComparison.Ordinal));
    }

    private void Turn(HumanBodyBones bone, Quaternion rotation)
    {
        Get(bone).localRotation = rotation;
        int index = Array.FindIndex(_description.skeleton, item => item.name == $"the {bone}");
        _description.skeleton[index].rotation = rotation;
    }

    private Transform Get(HumanBodyBones bone) => _root.GetComponentsInChildren<Transform>().Single(item => item.name == $"the {bone}");
}
