using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public sealed class CalculationOrderTests
{
    [Fact]
    public void The_bones_stand_in_the_order_of_Appendix_C() =>
        Assert.Equal(ManualTables.AppendixC, CalculationOrder.Bones.ToArray().Select(bone => bone.ToString()).ToArray());

    [Fact]
    public void The_index_of_a_bone_is_its_place()
    {
        for (int i = 0; i < 59; i++)
            Assert.Equal(i, CalculationOrder.IndexOf(CalculationOrder.Bones[i]));

        Assert.Equal(59, CalculationOrder.Bones.Length);
        Assert.Equal(59, CalculationOrder.Bones.ToArray().Distinct().Count());
    }

    [Fact]
    public void The_body_comes_before_every_finger()
    {
        Assert.Equal(21, CalculationOrder.BodyBoneCount);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            string name = bone.ToString();
            bool finger = name.Contains("Hand", StringComparison.Ordinal) && !name.EndsWith("Hand", StringComparison.Ordinal);
            Assert.Equal(finger, CalculationOrder.IndexOf(bone) >= CalculationOrder.BodyBoneCount);
        }
    }
}
