using System.Numerics;
using NeuronMocap.Bvh;

namespace NeuronMocap.Tests.Bvh;

public class BvhHierarchyBuilderTests
{
    [Fact]
    public void Joints_and_channels_are_numbered_as_they_are_added()
    {
        var builder = new BvhHierarchyBuilder();
        BvhJoint hips = builder.Add("Hips", null, new Vector3(0, 93, 0), [BvhChannel.Yposition, BvhChannel.Yrotation]);
        BvhJoint leg = builder.Add("Leg", hips, Vector3.UnitX, [], Vector3.UnitY);
        BvhJoint spine = builder.Add("Spine", hips, Vector3.UnitZ, [BvhChannel.Xrotation, BvhChannel.Xrotation, BvhChannel.Zrotation]);
        BvhJoint prop = builder.Add("Prop", null, Vector3.Zero, [BvhChannel.Zposition]);
        BvhHierarchy hierarchy = builder.Build();

        Assert.Equal([hips, leg, spine, prop], hierarchy.Joints);
        Assert.Equal([0, 1, 2, 3], hierarchy.Joints.Select(joint => joint.Index));
        Assert.Equal([null, hips, hips, null], hierarchy.Joints.Select(joint => joint.Parent));
        Assert.Equal([0, 2, 2, 5], hierarchy.Joints.Select(joint => joint.FirstChannel));
        Assert.Equal(6, hierarchy.ChannelCount);
        Assert.Equal([null, Vector3.UnitY, null, null], hierarchy.Joints.Select(joint => joint.EndSite));
        Assert.Equal([BvhChannel.Xrotation, BvhChannel.Xrotation, BvhChannel.Zrotation], spine.Channels);
    }

    [Fact]
    public void Joints_are_added_depth_first()
    {
        var builder = new BvhHierarchyBuilder();
        BvhJoint hips = builder.Add("Hips", null, default, []);
        BvhJoint leg = builder.Add("Leg", hips, default, []);
        builder.Add("Spine", hips, default, []);

        Assert.Throws<ArgumentException>(() => builder.Add("Foot", leg, default, []));
        BvhJoint foreign = new BvhHierarchyBuilder().Add("Hips", null, default, []);
        Assert.Throws<ArgumentException>(() => builder.Add("Head", foreign, default, []));
    }

    [Theory]
    [InlineData("")]
    [InlineData(" a")]
    [InlineData("a\t")]
    [InlineData("a{")]
    [InlineData("a\nb")]
    public void An_unwritable_name_is_refused(string name) =>
        Assert.Throws<ArgumentException>(() => new BvhHierarchyBuilder().Add(name, null, default, []));

    [Fact]
    public void The_builder_keeps_to_the_readers_limits()
    {
        var builder = new BvhHierarchyBuilder();
        Assert.Throws<InvalidOperationException>(builder.Build);
        Assert.Throws<ArgumentException>(() => builder.Add("a", null, default, [BvhChannel.Unknown]));
        Assert.Throws<ArgumentNullException>(() => builder.Add(null!, null, default, []));

        BvhJoint? parent = null;
        for (int depth = 0; depth < BvhDocument.MaxDepth; depth++)
            parent = builder.Add("a", parent, default, []);

        Assert.Throws<InvalidOperationException>(() => builder.Add("a", parent, default, []));
        for (int joint = BvhDocument.MaxDepth; joint < BvhDocument.MaxJoints; joint++)
            builder.Add("a", null, default, []);

        Assert.Throws<InvalidOperationException>(() => builder.Add("a", null, default, []));
        Assert.Equal(BvhDocument.MaxJoints, builder.Build().Joints.Count);
        Assert.Throws<InvalidOperationException>(builder.Build);
        Assert.Throws<InvalidOperationException>(() => builder.Add("a", null, default, []));
    }

    [Fact]
    public void A_refused_joint_leaves_the_builder_as_it_was()
    {
        var builder = new BvhHierarchyBuilder();
        BvhJoint hips = builder.Add("Hips", null, default, [BvhChannel.Xrotation]);
        Assert.Throws<ArgumentException>(() => builder.Add("Leg", null, default, [BvhChannel.Xrotation, (BvhChannel)7]));
        builder.Add("Spine", hips, default, [BvhChannel.Xrotation]);
        Assert.Equal(2, builder.Build().ChannelCount);
    }

    [Fact]
    public void A_document_is_created_from_a_hierarchy_and_rows()
    {
        var builder = new BvhHierarchyBuilder();
        builder.Add("Hips", null, default, [BvhChannel.Xrotation, BvhChannel.Yrotation]);
        BvhHierarchy hierarchy = builder.Build();
        var document = new BvhDocument(hierarchy, new BvhFrameTime(1, 60), [1, 2, 3, 4]);

        Assert.Same(hierarchy, document.Hierarchy);
        Assert.Equal(2, document.FrameCount);
        BvhSamples.AssertBits([3, 4], document.GetValues(1));
        Assert.Equal(60, document.FrameRate);
        Assert.Equal(1 / 60.0, document.DeclaredFrameTime);
        Assert.Equal(BvhTextFormat.AxisNeuron, document.TextFormat);
        Assert.Empty(document.Repairs);
        Assert.Throws<ArgumentException>(() => new BvhDocument(hierarchy, new BvhFrameTime(1, 60), [1, 2, 3]));
        Assert.Throws<ArgumentException>(() => new BvhDocument(hierarchy, default, []));
        Assert.Throws<ArgumentNullException>(() => new BvhDocument(null!, new BvhFrameTime(1, 60), []));
        Assert.Throws<ArgumentNullException>(() => new BvhDocument(hierarchy, new BvhFrameTime(1, 60), null!));
    }
}
