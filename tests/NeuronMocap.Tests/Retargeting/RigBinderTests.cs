using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class RigBinderTests
{
    [Theory]
    [InlineData("", "", SkeletonVariant.Neck1)]
    [InlineData("Robot_", "", SkeletonVariant.Neck1)]
    [InlineData("mixamorig:", "", SkeletonVariant.Neck1)]
    [InlineData("Actor 1 ", "_jnt", SkeletonVariant.Spine3)]
    public void The_names_of_bvh_files_are_found_with_their_prefix_given_or_guessed(string prefix, string suffix, SkeletonVariant variant)
    {
        string[] names = ["Armature", "Mesh", .. Names(variant).Select(name => prefix + name + suffix)];
        foreach (string? given in new[] { prefix, null })
        {
            RigBinding binding = RigBinder.Bind(names, given, suffix, variant);
            Assert.Equal([.. Enumerable.Range(2, 59)], binding.Nodes.ToArray());
            Assert.Empty(binding.Missing);
            Assert.Empty(binding.Ambiguities);
            Assert.Equal(prefix, binding.Prefix);
            Assert.Equal(59, binding.FoundCount);
        }
    }

    [Theory]
    [InlineData(Bone.LeftArm, "Left arm")]
    [InlineData(Bone.LeftArm, "leftarm")]
    [InlineData(Bone.LeftArm, "L_Arm")]
    [InlineData(Bone.LeftArm, "arm.L")]
    [InlineData(Bone.LeftArm, "upper_arm.L")]
    [InlineData(Bone.LeftArm, "LeftUpperArm")]
    [InlineData(Bone.LeftArm, "lUpperArm")]
    [InlineData(Bone.LeftArm, "character|rig:Left_Arm")]
    [InlineData(Bone.RightLeg, "calf_r")]
    [InlineData(Bone.RightLeg, "RightLowerLeg")]
    [InlineData(Bone.RightUpLeg, "R Thigh")]
    [InlineData(Bone.RightFoot, "Right Ankle")]
    [InlineData(Bone.Hips, "pelvis")]
    [InlineData(Bone.Hips, "HIPS")]
    [InlineData(Bone.Spine1, "spine_02")]
    [InlineData(Bone.Spine1, "Chest")]
    [InlineData(Bone.Spine2, "UpperChest")]
    [InlineData(Bone.Neck, "neck_01")]
    [InlineData(Bone.LeftShoulder, "clavicle_l")]
    [InlineData(Bone.LeftHandIndex1, "index_01_l")]
    [InlineData(Bone.LeftHandPinky3, "Left Little Distal")]
    [InlineData(Bone.LeftHandThumb2, "LeftThumbIntermediate")]
    [InlineData(Bone.RightInHandMiddle, "middle_metacarpal_r")]
    public void Spellings_that_are_common_are_understood(Bone bone, string name)
    {
        RigBinding binding = RigBinder.Bind(["Root", name]);
        Assert.Equal(1, binding.GetNode(bone));
        Assert.Equal(58, binding.Missing.Count);
        Assert.DoesNotContain(bone, binding.Missing);
    }

    // Bone names of well-known kinds of rigs, and how many of the 59 bones they have.
    [Theory]
    [InlineData(21, "root pelvis spine_01 spine_02 spine_03 neck_01 head clavicle_l upperarm_l lowerarm_l hand_l clavicle_r upperarm_r lowerarm_r hand_r thigh_l calf_l foot_l thigh_r calf_r foot_r ball_r ik_foot_root ik_hand_gun twist_l index_01_l")]
    [InlineData(13, "J_Bip_C_Hips J_Bip_C_Spine J_Bip_C_Chest J_Bip_C_UpperChest J_Bip_C_Neck J_Bip_C_Head J_Bip_L_Shoulder J_Bip_L_UpperArm J_Bip_L_LowerArm J_Bip_L_Hand J_Bip_L_Index1 J_Bip_R_UpperLeg J_Bip_R_Foot J_Sec_L_Bust1 J_Bip_L_ToeBase")]
    [InlineData(12, "mixamorig:Hips mixamorig:Spine mixamorig:Spine1 mixamorig:Spine2 mixamorig:Neck mixamorig:Head mixamorig:HeadTop_End mixamorig:LeftShoulder mixamorig:LeftArm mixamorig:LeftForeArm mixamorig:LeftHand mixamorig:LeftHandThumb1 mixamorig:LeftUpLeg")]
    public void Rigs_of_other_programs_are_bound(int found, string names)
    {
        RigBinding binding = RigBinder.Bind(names.Split(' '));
        Assert.True(binding.FoundCount == found, string.Join(", ", BoneHierarchy.Bones.ToArray().Except(binding.Missing)));
        Assert.Empty(binding.Ambiguities);
    }

    [Fact]
    public void Explicit_names_win_over_exact_and_similar_ones()
    {
        string[] names = ["Hips", "left_arm", "LeftArm", "Bone042"];
        Assert.Equal(2, RigBinder.Bind(names).GetNode(Bone.LeftArm));
        Assert.Equal(3, RigBinder.Bind(names, overrides: new Dictionary<Bone, string> { [Bone.LeftArm] = "Bone042" }).GetNode(Bone.LeftArm));

        RigBinding wrong = RigBinder.Bind(names, overrides: new Dictionary<Bone, string> { [Bone.LeftArm] = "Bone043" });
        Assert.Contains(Bone.LeftArm, wrong.Missing);
        Assert.Equal(-1, wrong.GetNode(Bone.LeftArm));
    }

    [Fact]
    public void Ambiguous_nodes_are_named_and_the_first_is_used()
    {
        RigBinding binding = RigBinder.Bind(["Hips", "Head", "left_hand", "Head", "hand.l"], "");
        Assert.Equal((1, 2), (binding.GetNode(Bone.Head), binding.GetNode(Bone.LeftHand)));
        Assert.Equal([Bone.Head, Bone.LeftHand], binding.Ambiguities.Select(ambiguity => ambiguity.Bone));
        Assert.Equal([1, 3], binding.Ambiguities[0].Nodes);
        Assert.Equal([2, 4], binding.Ambiguities[1].Nodes);
    }

    [Fact]
    public void The_figure_with_more_bones_is_bound()
    {
        RigBinding binding = RigBinder.Bind(["Prop_Hips", "Prop_Spine", "Robot_Hips", "Robot_Spine", "Robot_Head"]);
        Assert.Equal(("Robot_", 2, 4), (binding.Prefix, binding.GetNode(Bone.Hips), binding.GetNode(Bone.Head)));
    }

    [Fact]
    public void An_empty_rig_binds_nothing()
    {
        Assert.Equal(59, RigBinder.Bind([]).Missing.Count);
        Assert.Equal(59, RigBinder.Bind(["", "Cube", "Right", "Left", "L", "hand", "_", ":"]).Missing.Count);
    }

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void No_name_belongs_to_two_bones(SkeletonVariant variant)
    {
        Assert.All(RigNames.Rows(variant), row =>
        {
            (Bone Bone, NodeName[] Names)[] others = [.. row.Others()];
            NodeName[] names = [.. others.SelectMany(static one => one.Names), .. row.SpineNames.SelectMany(static one => one), .. row.NeckNames.SelectMany(static one => one)];
            Assert.Equal(names.Length, names.Distinct().Count());
            Assert.Equal(others.Length, others.Select(static one => one.Bone).Distinct().Count());
            Assert.Equal(others.First(static one => one.Bone == Bone.Hips).Names, row.HipsNames);
        });
    }

    private static IEnumerable<string> Names(SkeletonVariant variant) =>
        BoneHierarchy.Bones.ToArray().Select(bone => BoneHierarchy.GetName(bone, variant));
}
