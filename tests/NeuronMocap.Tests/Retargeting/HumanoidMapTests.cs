using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class HumanoidMapTests
{
    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void Fifty_of_the_bones_have_a_source(SkeletonVariant variant)
    {
        Bone?[] sources = [.. All().Select(bone => HumanoidMap.GetBone(bone, variant, HumanoidBoneSet.All))];
        Assert.Equal(50, sources.Count(source => source is not null));
        Assert.Equal(50, sources.Where(source => source is not null).Distinct().Count());
        Assert.All(
            [HumanoidBone.LeftToes, HumanoidBone.RightToes, HumanoidBone.LeftEye, HumanoidBone.RightEye, HumanoidBone.Jaw],
            bone => Assert.Null(HumanoidMap.GetBone(bone, variant, HumanoidBoneSet.All)));
    }

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void Every_bone_has_the_source_of_the_table(SkeletonVariant variant)
    {
        foreach (bool chest in (ReadOnlySpan<bool>)[false, true])
        {
            foreach (bool upperChest in (ReadOnlySpan<bool>)[false, true])
            {
                HumanoidBoneSet present = HumanoidBoneSet.All;
                present = chest ? present : present.Without(HumanoidBone.Chest);
                present = upperChest ? present : present.Without(HumanoidBone.UpperChest);
                foreach (HumanoidBone bone in All().Where(present.Contains))
                    Assert.Equal(ExpectedMap.Source(bone, variant, present), HumanoidMap.GetBone(bone, variant, present));
            }
        }
    }

    [Fact]
    public void Fifteen_bones_are_required()
    {
        HumanoidBone[] required = [.. All().Where(HumanoidBones.IsRequired)];
        Assert.Equal(
            [
                HumanoidBone.Hips, HumanoidBone.LeftUpperLeg, HumanoidBone.RightUpperLeg, HumanoidBone.LeftLowerLeg, HumanoidBone.RightLowerLeg,
                HumanoidBone.LeftFoot, HumanoidBone.RightFoot, HumanoidBone.Spine, HumanoidBone.Head, HumanoidBone.LeftUpperArm,
                HumanoidBone.RightUpperArm, HumanoidBone.LeftLowerArm, HumanoidBone.RightLowerArm, HumanoidBone.LeftHand, HumanoidBone.RightHand,
            ],
            required);
    }

    // Unity's numbers, at both ends of each block.
    [Theory]
    [InlineData(HumanoidBone.Hips, 0, "Hips")]
    [InlineData(HumanoidBone.LeftUpperLeg, 1, "LeftUpperLeg")]
    [InlineData(HumanoidBone.RightFoot, 6, "RightFoot")]
    [InlineData(HumanoidBone.Neck, 9, "Neck")]
    [InlineData(HumanoidBone.LeftShoulder, 11, "LeftShoulder")]
    [InlineData(HumanoidBone.RightHand, 18, "RightHand")]
    [InlineData(HumanoidBone.LeftToes, 19, "LeftToes")]
    [InlineData(HumanoidBone.Jaw, 23, "Jaw")]
    [InlineData(HumanoidBone.LeftThumbProximal, 24, "Left Thumb Proximal")]
    [InlineData(HumanoidBone.LeftLittleDistal, 38, "Left Little Distal")]
    [InlineData(HumanoidBone.RightThumbProximal, 39, "Right Thumb Proximal")]
    [InlineData(HumanoidBone.RightIndexIntermediate, 43, "Right Index Intermediate")]
    [InlineData(HumanoidBone.RightLittleDistal, 53, "Right Little Distal")]
    [InlineData(HumanoidBone.UpperChest, 54, "UpperChest")]
    public void Numbers_and_names_are_Unitys(HumanoidBone bone, int number, string name)
    {
        Assert.Equal(number, (int)bone);
        Assert.Equal(name, HumanoidBones.GetName(bone));
    }

    [Fact]
    public void Parents_are_those_of_a_body()
    {
        string[] lines =
        [
            "LeftUpperLeg Hips", "LeftLowerLeg LeftUpperLeg", "LeftFoot LeftLowerLeg", "LeftToes LeftFoot",
            "RightUpperLeg Hips", "RightLowerLeg RightUpperLeg", "RightFoot RightLowerLeg", "RightToes RightFoot",
            "Spine Hips", "Chest Spine", "UpperChest Chest", "Neck UpperChest", "Head Neck", "LeftEye Head", "RightEye Head", "Jaw Head",
            "LeftShoulder UpperChest", "LeftUpperArm LeftShoulder", "LeftLowerArm LeftUpperArm", "LeftHand LeftLowerArm",
            "RightShoulder UpperChest", "RightUpperArm RightShoulder", "RightLowerArm RightUpperArm", "RightHand RightLowerArm",
        ];
        Dictionary<string, string> parents = lines.Select(line => line.Split(' ')).ToDictionary(pair => pair[0], pair => pair[1]);
        foreach (string side in (string[])["Left", "Right"])
        {
            foreach (string finger in (string[])["Thumb", "Index", "Middle", "Ring", "Little"])
            {
                parents[$"{side}{finger}Proximal"] = $"{side}Hand";
                parents[$"{side}{finger}Intermediate"] = $"{side}{finger}Proximal";
                parents[$"{side}{finger}Distal"] = $"{side}{finger}Intermediate";
            }
        }

        Assert.Null(HumanoidBones.GetParent(HumanoidBone.Hips));
        Assert.Equal(54, parents.Count);
        Assert.All(parents, pair => Assert.Equal(pair.Value, HumanoidBones.GetParent(Enum.Parse<HumanoidBone>(pair.Key)).ToString()));
    }

    [Fact]
    public void A_bone_and_its_source_are_of_the_same_part()
    {
        foreach (SkeletonVariant variant in Enum.GetValues<SkeletonVariant>())
        {
            foreach (HumanoidBone bone in All())
            {
                if (HumanoidMap.GetBone(bone, variant, HumanoidBoneSet.All) is { } source)
                    Assert.Equal(HumanoidBones.GetPart(bone), HumanoidBones.GetPart(source, variant));
            }
        }

        Assert.Equal(BodyParts.LeftLeg, HumanoidBones.GetPart(HumanoidBone.LeftToes));
        Assert.Equal(BodyParts.RightLeg, HumanoidBones.GetPart(HumanoidBone.RightToes));
        Assert.Equal(BodyParts.Head, HumanoidBones.GetPart(HumanoidBone.Jaw));
        Assert.Equal(BodyParts.LeftFingers, HumanoidBones.GetPart(Bone.LeftInHandIndex));
        Assert.Equal(BodyParts.LeftArm, HumanoidBones.GetPart(HumanoidBone.LeftShoulder));
        Assert.Equal(BodyParts.RightLeg, HumanoidBones.GetPart(HumanoidBone.RightFoot));
    }

    [Fact]
    public void Parts_add_up_to_the_body()
    {
        BodyParts sum = BodyParts.None;
        foreach (HumanoidBone bone in All())
            sum |= HumanoidBones.GetPart(bone);

        Assert.Equal(BodyParts.All, sum);
        Assert.Equal(BodyParts.All, BodyParts.Hips | BodyParts.UpperBody | BodyParts.Legs);
    }

    [Fact]
    public void A_set_contains_its_bones()
    {
        HumanoidBoneSet set = default;
        Assert.Equal(0, set.Count);
        set = set.With(HumanoidBone.UpperChest).With(HumanoidBone.Hips).With(HumanoidBone.Hips);
        Assert.Equal(2, set.Count);
        Assert.True(set.Contains(HumanoidBone.UpperChest));
        Assert.False(set.Contains(HumanoidBone.Chest));
        Assert.False(set.Contains((HumanoidBone)55));
        Assert.Equal(set, default(HumanoidBoneSet).With(HumanoidBone.Hips).With(HumanoidBone.UpperChest));
        Assert.Equal(55, HumanoidBoneSet.All.Count);
        Assert.Equal(1, set.Without(HumanoidBone.Hips).Count);
        Assert.Throws<ArgumentOutOfRangeException>(() => set.With((HumanoidBone)55));
    }

    [Fact]
    public void Unknown_bones_are_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => HumanoidBones.GetName((HumanoidBone)55));
        Assert.Throws<ArgumentOutOfRangeException>(() => HumanoidBones.GetParent((HumanoidBone)(-1)));
        Assert.Throws<ArgumentOutOfRangeException>(() => HumanoidMap.GetBone((HumanoidBone)55, SkeletonVariant.Neck1, HumanoidBoneSet.All));
        Assert.Throws<ArgumentOutOfRangeException>(() => HumanoidBones.GetPart((Bone)59));
    }

    private static IEnumerable<HumanoidBone> All() => Enumerable.Range(0, HumanoidBones.Count).Select(index => (HumanoidBone)index);
}
