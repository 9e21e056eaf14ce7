using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public sealed class BoneHierarchyTests
{
    [Fact]
    public void The_bones_are_those_of_Appendix_A_in_its_order()
    {
        Assert.Equal(59, BoneHierarchy.BoneCount);
        Assert.Equal(ManualTables.AppendixA, Enum.GetNames<Bone>());
        Assert.Equal(Enumerable.Range(0, 59), Enum.GetValues<Bone>().Select(bone => (int)bone));
        Assert.Equal(Enum.GetValues<Bone>(), BoneHierarchy.Bones.ToArray());
    }

    [Theory]
    [InlineData(Bone.Spine2, 9)]
    [InlineData(Bone.Neck, 10)]
    [InlineData(Bone.Head, 12)]
    [InlineData(Bone.RightHand, 16)]
    [InlineData(Bone.RightHandPinky3, 35)]
    [InlineData(Bone.LeftShoulder, 36)]
    [InlineData(Bone.LeftHandPinky3, 58)]
    public void A_bones_number_is_its_index_in_the_data(Bone bone, int expected) => Assert.Equal(expected, (int)bone);

    [Fact]
    public void Names_and_parents_of_the_newer_variant_match_Appendix_B()
    {
        foreach ((string name, string? parent, _, _, _) in ManualTables.AppendixB)
        {
            Bone bone = Enum.Parse<Bone>(name);
            Bone? expected = parent is null ? null : Enum.Parse<Bone>(parent);

            Assert.Equal(name, BoneHierarchy.GetName(bone));
            Assert.True(expected == BoneHierarchy.GetParent(bone), $"{name} hangs from {BoneHierarchy.GetParent(bone)}.");
        }
    }

    [Fact]
    public void The_older_variant_differs_in_two_names_and_in_the_parent_of_the_shoulders_only()
    {
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            string name = bone switch
            {
                Bone.Neck => "Spine3",
                Bone.Neck1 => "Neck",
                _ => ManualTables.AppendixA[(int)bone],
            };
            Bone? parent = bone is Bone.RightShoulder or Bone.LeftShoulder ? (Bone)10 : BoneHierarchy.GetParent(bone);

            Assert.Equal(name, BoneHierarchy.GetName(bone, SkeletonVariant.Spine3));
            Assert.Equal(parent, BoneHierarchy.GetParent(bone, SkeletonVariant.Spine3));
        }
    }

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void A_parent_comes_before_its_children(SkeletonVariant variant)
    {
        Assert.Null(BoneHierarchy.GetParent(Bone.Hips, variant));
        foreach (Bone bone in BoneHierarchy.Bones[1..])
            Assert.True(BoneHierarchy.GetParent(bone, variant) < bone);
    }

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void Every_bone_is_found_by_its_name(SkeletonVariant variant)
    {
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Assert.True(BoneHierarchy.TryFind(BoneHierarchy.GetName(bone, variant), variant, out Bone found));
            Assert.Equal(bone, found);
        }
    }

    [Theory]
    [InlineData("Spine3", SkeletonVariant.Neck1)]
    [InlineData("Neck1", SkeletonVariant.Spine3)]
    [InlineData("hips", SkeletonVariant.Neck1)]
    [InlineData("Hips ", SkeletonVariant.Neck1)]
    [InlineData("", SkeletonVariant.Neck1)]
    public void An_unknown_name_is_not_found(string name, SkeletonVariant variant) =>
        Assert.False(BoneHierarchy.TryFind(name, variant, out _));

    [Theory]
    [InlineData(-1)]
    [InlineData(59)]
    [InlineData(int.MaxValue)]
    [InlineData(int.MinValue)]
    public void An_invalid_bone_number_is_refused(int number)
    {
        var bone = (Bone)number;
        Assert.Throws<ArgumentOutOfRangeException>(() => BoneHierarchy.GetParent(bone));
        Assert.Throws<ArgumentOutOfRangeException>(() => BoneHierarchy.GetName(bone));
        Assert.Throws<ArgumentOutOfRangeException>(() => CalculationOrder.IndexOf(bone));
        Assert.Throws<ArgumentOutOfRangeException>(() => DefaultOffsets.Get(bone));
        Assert.Throws<ArgumentOutOfRangeException>(() => default(ChannelLayout).GetPositionIndex(bone));
        Assert.Throws<ArgumentOutOfRangeException>(() => default(ChannelLayout).GetRotationIndex(bone));
        Assert.False(DefaultOffsets.TryGetEndSite(bone, out _));
    }
}
