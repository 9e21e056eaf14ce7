using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using static NeuronMocap.Tests.Retargeting.RetargetAssert;

namespace NeuronMocap.Tests.Retargeting;

public sealed class RetargeterTests
{
    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void The_actors_own_skeleton_moves_as_the_actor(SkeletonVariant variant)
    {
        var body = SkeletonBody.GetDefault(variant);
        TargetRig rig = TestRigs.Actor(body);
        var random = new Random(1);
        for (int i = 0; i < 100; i++)
        {
            BoneTransform[] pose = RandomPoses.Pose(random);
            RetargetedPose result = Retarget(rig, body, pose);
            AssertNear(UnityAxes.ToUnityPosition(pose[0].Position), result.HipsLocalPosition, 1e-5f);
            foreach (Bone bone in BoneHierarchy.Bones)
                AssertTurn(UnityAxes.ToUnityRotation(pose[(int)bone].Rotation), result.LocalRotations[rig.GetNode(bone)], 2e-6, bone.ToString());
        }
    }

    [Fact]
    public void An_actor_at_rest_leaves_every_character_at_rest()
    {
        for (int seed = 0; seed < 500; seed++)
        {
            var character = new RandomRig(seed, (RigScales)(seed % 4));
            TargetRig rig = character.Create();
            SkeletonBody body = SkeletonBody.GetDefault((SkeletonVariant)(seed % 2));
            RetargetedPose result = Retarget(rig, body, TestRigs.RestPose(body));
            result.UpdateWorld();
            AssertNear(rig.RestPositions[rig.HipsNode], result.WorldPositions[rig.HipsNode], 1e-5f);
            for (int node = 0; node < character.Nodes.Length; node++)
                AssertTurn(character.Nodes[node].Rotation, result.LocalRotations[node], 1e-6, $"seed {seed}, {character.Nodes[node].Name}");
        }
    }

    // The bone is missing from the map, not from the character, so its rotation must reach its descendants.
    [Theory]
    [InlineData(HumanoidBone.UpperChest)]
    [InlineData(HumanoidBone.UpperChest, HumanoidBone.Chest)]
    [InlineData(HumanoidBone.LeftShoulder, HumanoidBone.RightShoulder)]
    [InlineData(HumanoidBone.Neck)]
    [InlineData(HumanoidBone.LeftIndexProximal)]
    [InlineData(HumanoidBone.LeftLowerArm)]
    public void A_missing_bones_rotation_reaches_its_children(params HumanoidBone[] missing)
    {
        TargetRig whole = TestRigs.Humanoid();
        TargetRig lacking = TestRigs.Humanoid(1, missing);
        BoneTransform[] pose = RandomPoses.Pose(new Random(2));
        foreach (SkeletonVariant variant in Enum.GetValues<SkeletonVariant>())
        {
            RetargetedPose one = Retarget(whole, SkeletonBody.GetDefault(variant), pose);
            RetargetedPose other = Retarget(lacking, SkeletonBody.GetDefault(variant), pose);
            one.UpdateWorld();
            other.UpdateWorld();
            foreach (HumanoidBone bone in TestRigs.Order)
            {
                // The topmost bone of the trunk also stands for the missing bones above it.
                int node = lacking.GetNode(bone);
                if (node >= 0 && bone is not (HumanoidBone.Spine or HumanoidBone.Chest) && !IsRest(bone))
                    AssertTurn(one.WorldRotations[node], other.WorldRotations[node], 3e-6, $"{bone}, {variant}");
            }

            foreach (HumanoidBone bone in missing)
            {
                int node = whole.GetNode(bone);
                Assert.False(other.IsDriven(node));
                Assert.Equal(Quaternion.Identity, other.LocalRotations[node]);
            }
        }
    }

    [Fact]
    public void A_twist_bone_rests_without_affecting_its_children()
    {
        RigNode[] nodes = TestRigs.HumanoidNodes();
        int[] nodeByBone = TestRigs.NodeOf();
        int forearm = nodeByBone[(int)HumanoidBone.LeftLowerArm];
        int hand = nodeByBone[(int)HumanoidBone.LeftHand];
        Quaternion twist = RandomPoses.Turn(new Random(3));
        var back = Quaternion.Conjugate(twist);

        // It is at the end of the list, so the hand must move after it.
        nodes = [.. nodes, new RigNode("Twist", forearm, nodes[hand].Position / 2, twist), nodes[hand] with { Parent = nodes.Length, Rotation = back }];
        nodeByBone[(int)HumanoidBone.LeftHand] = nodes.Length - 1;

        // A node that is a bone without a source makes no difference.
        nodeByBone[(int)HumanoidBone.Jaw] = nodes.Length - 2;
        foreach (HumanoidBone bone in TestRigs.Order.Where(bone => HumanoidBones.GetPart(bone) == BodyParts.LeftFingers))
            nodeByBone[(int)bone] = -1;

        BoneTransform[] pose = RandomPoses.Pose(new Random(4));
        RetargetedPose plain = Retarget(TestRigs.Humanoid(), SkeletonBody.GetDefault(), pose);
        RetargetedPose twisted = Retarget(TargetRig.CreateHumanoid(nodes, nodeByBone), SkeletonBody.GetDefault(), pose);
        plain.UpdateWorld();
        twisted.UpdateWorld();
        AssertTurn(plain.WorldRotations[hand], twisted.WorldRotations[^1], 3e-6, "hand");
        Assert.Equal(twisted.Rig.Nodes[^2].Rotation, twisted.LocalRotations[^2]);
        Assert.False(twisted.IsDriven(nodes.Length - 2));
    }

    [Fact]
    public void Another_body_may_have_another_variant()
    {
        TargetRig rig = TestRigs.Humanoid();
        BoneTransform[] pose = RandomPoses.Pose(new Random(10));
        RetargetedPose expected = Retarget(rig, SkeletonBody.GetDefault(SkeletonVariant.Spine3), pose);
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        var result = new RetargetedPose(rig);
        Assert.True(retargeter.TryRetarget(pose, result));
        int chest = rig.GetNode(HumanoidBone.UpperChest);
        Assert.True(Affine.Turned(expected.LocalRotations[chest]).AngleTo(result.LocalRotations[chest]) > 0.1);

        retargeter.SetBody(SkeletonBody.GetDefault(SkeletonVariant.Spine3));
        Assert.True(retargeter.TryRetarget(pose, result));
        Assert.Equal(SkeletonVariant.Spine3, retargeter.Body.Variant);
        AssertAlike(expected, result, 0);
    }

    // Quaternions that are recorded or blended by component must not change their sign from frame to frame.
    [Fact]
    public void Rotations_stay_in_one_hemisphere()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            var random = new Random(seed);
            Vector3[] axes = [.. Enumerable.Range(0, BoneHierarchy.BoneCount).Select(_ => RandomPoses.Direction(random))];
            TargetRig rig = new RandomRig(seed, (RigScales)(seed % 4)).Create();
            var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
            var result = new RetargetedPose(rig);
            Quaternion[] before = result.LocalRotations.ToArray();
            for (int degrees = 0; degrees < 750; degrees += 5)
            {
                // Quaternions may arrive with either sign.
                BoneTransform[] pose =
                [
                    .. axes.Select(axis => new BoneTransform(
                        Vector3.Zero, Quaternion.CreateFromAxisAngle(axis, degrees * MathF.PI / 180) * (random.Next(2) == 0 ? 1 : -1))),
                ];
                Assert.True(retargeter.TryRetarget(pose, result));
                for (int node = 0; node < before.Length; node++)
                    Assert.True(Quaternion.Dot(before[node], result.LocalRotations[node]) > (degrees == 0 ? 0 : 0.9f), $"seed {seed}, {degrees}, {node}");

                before = result.LocalRotations.ToArray();
            }
        }
    }

    [Theory]
    [InlineData(RigScales.None)]
    [InlineData(RigScales.Signs)]
    [InlineData(RigScales.Sheared)]
    internal void Nothing_is_allocated(RigScales scales)
    {
        TargetRig rig = new RandomRig(11, scales).Create();
        var options = new RetargetOptions();
        options.Weights.SetPart(BodyParts.Arms, 0.5f);
        options.Weights.SetPart(BodyParts.Head, 0);
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault(), options);
        var result = new RetargetedPose(rig);
        BoneTransform[] pose = RandomPoses.Pose(new Random(12));
        BoneTransform[] broken = [.. pose];
        broken[5] = default;
        Allocations.AssertNone(() =>
        {
            retargeter.TryRetarget(pose, result, BoneTransform.Identity);
            retargeter.TryRetarget(broken, result);
            result.UpdateWorld();
            result.SetWorldRotation(rig.HipsNode, Quaternion.Identity);
            result.SetHipsWorldPosition(Vector3.One);
            result.Reset();
        });
    }

    private static bool IsRest(HumanoidBone bone) =>
        HumanoidMap.GetBone(bone, SkeletonVariant.Neck1, HumanoidBoneSet.All) is null;
}
