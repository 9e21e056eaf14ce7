using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

/// <summary>Files of other programs, which put the name of the character before the names of all bones.</summary>
public sealed class BvhBonePrefixTests
{
    private const string Six = "6 Xposition Yposition Zposition Yrotation Xrotation Zrotation";

    [Theory]
    [InlineData("Robot_", SkeletonVariant.Neck1)]
    [InlineData("take 1|Robot:", SkeletonVariant.Spine3)]
    public void All_names_may_have_the_same_prefix(string prefix, SkeletonVariant variant)
    {
        string text = UnderRoot("Reference", Six, variant);
        BvhSkeletonMap expected = Create(text);
        BvhSkeletonMap map = Create(WithPrefix(text, prefix));
        float[] expectedValues = new float[186];
        float[] values = new float[186];
        expected.CopyValues(0, expectedValues);
        map.CopyValues(0, values);

        AssertBits(expectedValues, values);
        Assert.Equal((expected.Layout, expected.Format), (map.Layout, map.Format));
        Assert.Equal(prefix + "LeftHand", map[Bone.LeftHand].Name);
        Assert.Equal(expected.GetReference(0), map.GetReference(0));
        Assert.Empty(map.OtherJoints);
    }

    [Fact]
    public void The_first_of_two_characters_is_taken()
    {
        BvhSkeletonMap map = Create(Still(WithPrefix(Neuron(), "A:"), WithPrefix(Neuron(), "B:")));
        Assert.Equal("A:Head", map[Bone.Head].Name);
        Assert.Equal(59, map.OtherJoints.Count);
    }

    [Fact]
    public void A_character_that_lacks_bones_does_not_hide_the_next_one()
    {
        string without = WithPrefix(Neuron(edit: static (bone, joint) => bone == Bone.LeftHand ? joint.Replace("LeftHand", "LeftHook", StringComparison.Ordinal) : joint), "A:");
        Assert.Equal("B:Head", Create(Still(without, WithPrefix(Neuron(), "B:")))[Bone.Head].Name);
    }

    [Fact]
    public void A_helper_above_plain_names_does_not_matter()
    {
        const string Helper = "HIERARCHY\nROOT Ctrl_Hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION";
        BvhSkeletonMap map = Create(Still(Helper, Neuron()));
        Assert.Equal("Head", map[Bone.Head].Name);
        Assert.Equal("Ctrl_Hips", Assert.Single(map.OtherJoints).Name);
    }

    [Theory]
    [InlineData("Robot_", "The file has no joint named Robot_RightUpLeg; its first joint is named Robot_Hips.")]
    [InlineData("Robot", "The file has no joint named Hips; its first joint is named RobotHips.")]
    [InlineData("Robot2", "The file has no joint named Hips; its first joint is named Robot2Hips.")]
    public void A_prefix_of_the_hips_alone_is_not_neurons(string prefix, string told)
    {
        string text = Neuron(edit: (_, joint) => joint.Replace("ROOT ", "ROOT " + prefix, StringComparison.Ordinal));
        Assert.False(BvhSkeletonMap.TryCreate(Parse(text), out _, out string? reason));
        Assert.Equal(told, reason);
    }

    [Fact]
    public void The_other_variant_keeps_the_prefix() => AssertSame(
        Neuron(displacement: true),
        static take => take.WithVariant(SkeletonVariant.Spine3),
        "Robot:Spine3");

    [Fact]
    public void Without_displacement_the_hips_below_the_reference_still_move() => AssertSame(
        UnderRoot("Reference", Six, displacement: true),
        static take => take.WithoutDisplacement(out _),
        "Robot:Reference");

    [Fact]
    public void Takes_are_aligned_by_the_hips_below_the_reference() => AssertSame(
        UnderRoot("Reference", Six, displacement: true),
        static take => BvhEditing.Join([take, take], align: true),
        "Robot:Hips");

    // An edit of the take with a prefix has the values of the same edit without it.
    private static void AssertSame(string text, Func<BvhDocument, BvhDocument> edit, string name)
    {
        BvhDocument expected = edit(Parse(text));
        BvhDocument edited = edit(Parse(WithPrefix(text, "Robot:")));
        Assert.Equal(expected.Joints.Select(static joint => "Robot:" + joint.Name), edited.Joints.Select(static joint => joint.Name));
        Assert.Contains(edited.Joints, joint => joint.Name == name);
        Assert.Equal(expected.ChannelCount, edited.ChannelCount);
        for (int frame = 0; frame < expected.FrameCount; frame++)
            AssertBits(expected.GetValues(frame), edited.GetValues(frame));
    }

    // The hierarchies of some files, without rows.
    private static string Still(params string[] files) =>
        $"HIERARCHY\n{string.Concat(files.Select(static file => file["HIERARCHY\n".Length..file.IndexOf("MOTION", StringComparison.Ordinal)]))}MOTION\nFrames: 0\nFrame Time: 0.01\n";

    private static BvhSkeletonMap Create(string text)
    {
        Assert.True(BvhSkeletonMap.TryCreate(Parse(text), out BvhSkeletonMap? map, out string? reason), reason);
        return map;
    }
}
