using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class TargetRigTests
{
    [Fact]
    public void A_rig_knows_its_bones_and_nodes()
    {
        TargetRig rig = TestRigs.Humanoid(2, HumanoidBone.UpperChest, HumanoidBone.Jaw);
        Assert.True(rig.IsHumanoid);
        Assert.Equal(HumanoidBoneSet.All.Without(HumanoidBone.UpperChest).Without(HumanoidBone.Jaw), rig.Bones);
        Assert.Equal(-1, rig.GetNode(HumanoidBone.Jaw));
        Assert.Equal(-1, rig.GetNode(Bone.Head));
        Assert.Equal(rig.HipsNode, rig.GetNode(HumanoidBone.Hips));
        int hand = rig.GetNode(HumanoidBone.LeftHand);
        Assert.Equal(HumanoidBone.LeftHand, rig.GetHumanoidBone(hand));
        Assert.Null(rig.GetBone(hand));
        Assert.Null(rig.GetHumanoidBone(Array.IndexOf(TestRigs.Order, HumanoidBone.Jaw)));
        Assert.Equal(2 * 0.84102f, rig.HipsHeight, 1e-5f);
        Assert.Equal(2 * 0.74102f, rig.LegLength, 1e-5f);
        Assert.False(rig.IsSheared);
        Assert.Throws<ArgumentOutOfRangeException>(() => rig.GetNode((HumanoidBone)55));
    }

    [Fact]
    public void A_generic_rig_knows_the_bones_of_the_stream()
    {
        TargetRig rig = TestRigs.Actor(SkeletonBody.GetDefault());
        Assert.False(rig.IsHumanoid);
        Assert.Equal((int)Bone.LeftInHandRing, rig.GetNode(Bone.LeftInHandRing));
        Assert.Equal(Bone.LeftHand, rig.GetBone((int)Bone.LeftHand));
        Assert.Null(rig.GetHumanoidBone((int)Bone.LeftHand));
        Assert.Equal((int)Bone.LeftFoot, rig.GetNode(HumanoidBone.LeftFoot));
        Assert.Equal(-1, rig.GetNode(HumanoidBone.LeftToes));
        Assert.Equal(50, rig.Bones.Count);
        Assert.Equal(0.74102f, rig.LegLength, 1e-5f);
        Assert.Throws<ArgumentOutOfRangeException>(() => rig.GetNode((Bone)59));
    }

    // From the T-pose alone, to quarter turns. It is exactly the identity for the many characters in the usual orientation.
    [Fact]
    public void The_facing_of_a_character_is_found()
    {
        Assert.Equal(Quaternion.Identity, TestRigs.Humanoid().Facing);
        Assert.Equal(Quaternion.Identity, TestRigs.Actor(SkeletonBody.GetDefault()).Facing);
        var tilted = Quaternion.CreateFromYawPitchRoll(0.3f, 0.2f, -0.2f);
        foreach (float degrees in (ReadOnlySpan<float>)[0, 90, 180, 270])
        {
            var turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, degrees * MathF.PI / 180);
            RigNode[] nodes = TestRigs.Under(new RigNode("Armature", -1, Vector3.Zero, turn * tilted), TestRigs.HumanoidNodes());
            TargetRig rig = TargetRig.CreateHumanoid(nodes, TestRigs.Under(TestRigs.NodeOf()));
            Assert.True(Affine.Turned(turn).AngleTo(rig.Facing) < 1e-6, $"{degrees}");
        }
    }

    [Fact]
    public void An_ambiguous_character_faces_forward()
    {
        var between = Quaternion.CreateFromAxisAngle(Vector3.UnitY, MathF.PI / 4);
        RigNode[] nodes = TestRigs.Under(new RigNode("Armature", -1, Vector3.Zero, between), TestRigs.HumanoidNodes());
        Assert.Equal(Quaternion.Identity, TargetRig.CreateHumanoid(nodes, TestRigs.Under(TestRigs.NodeOf())).Facing);

        // Only hips.
        int[] nodeByBone = [.. Enumerable.Repeat(-1, HumanoidBones.Count)];
        nodeByBone[0] = 0;
        TargetRig lone = TargetRig.CreateHumanoid([new RigNode("Hips", -1, Vector3.UnitY, Quaternion.Identity)], nodeByBone);
        Assert.Equal(Quaternion.Identity, lone.Facing);
        Assert.Equal(0, lone.LegLength);
    }

    [Fact]
    public void Rotations_are_normalised()
    {
        RigNode[] nodes = TestRigs.HumanoidNodes();
        nodes[3] = nodes[3] with { Rotation = new Quaternion(0, 3, 0, 4) };
        Assert.Equal(new Quaternion(0, 0.6f, 0, 0.8f), TargetRig.CreateHumanoid(nodes, TestRigs.NodeOf()).Nodes[3].Rotation);
    }

    [Fact]
    public void A_shear_is_detected()
    {
        RigNode[] nodes = TestRigs.HumanoidNodes();
        nodes[0] = nodes[0] with { Scale = new Vector3(1, 1.1f, 1) };
        Assert.True(TargetRig.CreateHumanoid(nodes, TestRigs.NodeOf()).IsSheared);
        nodes[0] = nodes[0] with { Scale = new Vector3(1.1f, -1.1f, 1.1f) };
        Assert.False(TargetRig.CreateHumanoid(nodes, TestRigs.NodeOf()).IsSheared);

        // Without children.
        nodes[0] = nodes[0] with { Scale = Vector3.One };
        nodes[^1] = nodes[^1] with { Scale = new Vector3(1, 2, 3) };
        Assert.False(TargetRig.CreateHumanoid(nodes, TestRigs.NodeOf()).IsSheared);
    }

    [Fact]
    public void An_invalid_rig_is_refused()
    {
        AssertRefused("comes before its parent", nodes => nodes[2] = nodes[2] with { Parent = 2 });
        AssertRefused("comes before its parent", nodes => nodes[2] = nodes[2] with { Parent = -2 });
        AssertRefused("not a number", nodes => nodes[2] = nodes[2] with { Position = new Vector3(0, float.NaN, 0) });
        AssertRefused("not a number", nodes => nodes[2] = nodes[2] with { Scale = new Vector3(0, 0, float.PositiveInfinity) });
        AssertRefused("not a number", nodes => nodes[2] = nodes[2] with { Rotation = new Quaternion(float.NaN, 0, 0, 1) });
        AssertRefused("length zero", nodes => nodes[2] = nodes[2] with { Rotation = default });
        AssertRefused("is mapped to two bones", change: null, nodeByBone => nodeByBone[5] = nodeByBone[6]);
        AssertRefused("Node 55 does not exist", change: null, nodeByBone => nodeByBone[5] = 55);
        AssertRefused($"Node {-2} does not exist", change: null, nodeByBone => nodeByBone[5] = -2);
        AssertRefused("hips have no node", change: null, nodeByBone => nodeByBone[0] = -1);
        AssertRefused("below another bone", change: null, nodeByBone => (nodeByBone[0], nodeByBone[7]) = (nodeByBone[7], nodeByBone[0]));
        RigNode[] flat = TestRigs.Under(new RigNode("Armature", -1, Vector3.Zero, Quaternion.Identity, Vector3.Zero), TestRigs.HumanoidNodes());
        ArgumentException error = Assert.Throws<ArgumentException>(() => TargetRig.CreateHumanoid(flat, TestRigs.Under(TestRigs.NodeOf())));
        Assert.Contains("scale of zero", error.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => TargetRig.CreateHumanoid(TestRigs.HumanoidNodes(), new int[59]));
        Assert.Throws<ArgumentException>(() => TargetRig.CreateGeneric(TestRigs.HumanoidNodes(), new int[55]));
    }

    // Sibling bones, as created by some exporters and physics set-ups.
    [Fact]
    public void A_flat_rig_gets_world_rotations()
    {
        RigNode[] nodes = [.. TestRigs.HumanoidNodes().Select(node => node with { Parent = -1 }).Reverse()];
        int[] nodeByBone = [.. TestRigs.NodeOf().Select(node => nodes.Length - 1 - node)];
        TargetRig rig = TargetRig.CreateHumanoid(nodes, nodeByBone, Quaternion.Identity);
        BoneTransform[] pose = RandomPoses.Pose(new Random(1));
        var result = new RetargetedPose(rig);
        Assert.True(new Retargeter(rig, SkeletonBody.GetDefault()).TryRetarget(pose, result));
        Affine[] turns = ReferenceRetargeter.SourceTurns(pose, SkeletonVariant.Neck1);
        Assert.True(turns[(int)Bone.LeftHand].AngleTo(result.LocalRotations[nodeByBone[(int)HumanoidBone.LeftHand]]) < 3e-6);
        Assert.True(turns[0].AngleTo(result.LocalRotations[rig.HipsNode]) < 1e-6);
        Vector3 way = UnityAxes.ToUnityPosition(pose[0].Position) - new Vector3(0, 0.84102f, 0);
        Vector3 expected = nodes[rig.HipsNode].Position + (way * new Retargeter(rig, SkeletonBody.GetDefault()).Scale);
        Assert.True(Vector3.Distance(expected, result.HipsLocalPosition) < 1e-5f);

        var options = new RetargetOptions { Weights = BoneWeights.Only(BodyParts.All & ~BodyParts.Hips) };
        Assert.True(new Retargeter(rig, SkeletonBody.GetDefault(), options).TryRetarget(pose, result));
        Assert.Equal(nodes[rig.HipsNode].Position, result.HipsLocalPosition);
    }

    private static void AssertRefused(string words, Action<RigNode[]>? change, Action<int[]>? remap = null)
    {
        RigNode[] nodes = TestRigs.HumanoidNodes();
        int[] nodeByBone = TestRigs.NodeOf();
        change?.Invoke(nodes);
        remap?.Invoke(nodeByBone);
        ArgumentException error = Assert.Throws<ArgumentException>(() => TargetRig.CreateHumanoid(nodes, nodeByBone));
        Assert.Contains(words, error.Message, StringComparison.Ordinal);
    }
}
