using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public sealed class DefaultOffsetsTests
{
    private static readonly SkeletonVariant[] Variants = Enum.GetValues<SkeletonVariant>();

    [Fact]
    public void The_offsets_are_those_of_Appendix_B()
    {
        Assert.Equal(59, ManualTables.AppendixB.Length);
        foreach ((string name, _, float x, float y, float z) in ManualTables.AppendixB)
            Assert.Equal((name, new Vector3(x, y, z)), (name, DefaultOffsets.Get(Enum.Parse<Bone>(name))));
    }

    [Fact]
    public void The_end_sites_are_those_of_Appendix_B_and_belong_to_the_bones_without_children()
    {
        foreach ((string name, float x, float y, float z) in ManualTables.EndSites)
        {
            Assert.True(DefaultOffsets.TryGetEndSite(Enum.Parse<Bone>(name), out Vector3 offset));
            Assert.Equal((name, new Vector3(x, y, z)), (name, offset));
        }

        HashSet<Bone?> parents = [.. BoneHierarchy.Bones.ToArray().Select(bone => BoneHierarchy.GetParent(bone))];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            bool found = DefaultOffsets.TryGetEndSite(bone, out Vector3 offset);
            Assert.NotEqual(parents.Contains(bone), found);
            Assert.Equal(found, offset != Vector3.Zero);
        }
    }

    [Fact]
    public void Left_mirrors_right()
    {
        int pairs = 0;
        foreach (SkeletonVariant variant in Variants)
        {
            foreach (Bone right in BoneHierarchy.Bones)
            {
                string name = right.ToString();
                if (!name.StartsWith("Right", StringComparison.Ordinal))
                    continue;

                Bone left = Enum.Parse<Bone>("Left" + name["Right".Length..]);
                Assert.Equal(Mirror(DefaultOffsets.Get(right, variant)), DefaultOffsets.Get(left, variant));
                DefaultOffsets.TryGetEndSite(right, out Vector3 rightEnd);
                DefaultOffsets.TryGetEndSite(left, out Vector3 leftEnd);
                Assert.Equal(Mirror(rightEnd), leftEnd);
                pairs++;
            }
        }

        Assert.Equal(2 * 26, pairs);
    }

    [Fact]
    public void The_hips_are_as_high_as_a_leg_and_a_foot_are_long()
    {
        Assert.True(DefaultOffsets.TryGetEndSite(Bone.LeftFoot, out Vector3 toe));
        float leg = -(DefaultOffsets.Get(Bone.LeftUpLeg).Y + DefaultOffsets.Get(Bone.LeftLeg).Y + DefaultOffsets.Get(Bone.LeftFoot).Y + toe.Y);
        Assert.Equal(DefaultOffsets.Get(Bone.Hips).Y, leg, 1e-4f);
    }

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void Head_shoulders_and_hands_are_equal_in_both_variants(SkeletonVariant variant)
    {
        Assert.Equal(new Vector3(0, 144.102f, 0), StandingAt(Bone.Head, variant), Within(1e-3f));
        Assert.Equal(new Vector3(2.55f, 130.002f, 0), StandingAt(Bone.LeftShoulder, variant), Within(1e-3f));
        Assert.Equal(new Vector3(-64, 130.002f, 0), StandingAt(Bone.RightHand, variant), Within(1e-3f));
        Assert.Equal(new Vector3(-9.5f, 10, 0), StandingAt(Bone.RightFoot, variant), Within(1e-3f));
    }

    [Fact]
    public void The_older_variant_differs_in_the_spine_the_neck_and_the_shoulders_only()
    {
        IEnumerable<Bone> changed = BoneHierarchy.Bones.ToArray()
            .Where(bone => DefaultOffsets.Get(bone) != DefaultOffsets.Get(bone, SkeletonVariant.Spine3));
        Assert.Equal(
            [Bone.Spine, Bone.Spine1, Bone.Spine2, Bone.Neck, Bone.Neck1, Bone.Head, Bone.RightShoulder, Bone.LeftShoulder],
            changed);
    }

    private static Vector3 StandingAt(Bone bone, SkeletonVariant variant)
    {
        Vector3 place = Vector3.Zero;
        for (Bone? at = bone; at is { } next; at = BoneHierarchy.GetParent(next, variant))
            place += DefaultOffsets.Get(next, variant);

        return place;
    }

    private static Vector3 Mirror(Vector3 right) => new(-right.X, right.Y, right.Z);

    private static EqualityComparer<Vector3> Within(float tolerance) =>
        EqualityComparer<Vector3>.Create((a, b) => Vector3.Distance(a, b) <= tolerance);
}
