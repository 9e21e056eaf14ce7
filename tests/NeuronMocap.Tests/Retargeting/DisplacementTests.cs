using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class DisplacementTests
{
    [Theory]
    [InlineData(RigScales.None)]
    [InlineData(RigScales.Signs)]
    [InlineData(RigScales.Uniform)]
    internal void Every_driven_bone_is_where_the_actors_bone_is(RigScales scales)
    {
        for (int seed = 0; seed < 300; seed++)
        {
            var random = new Random(seed);
            var character = new RandomRig(seed, scales);
            SkeletonBody body = RandomPoses.Body(random);
            BoneTransform[] pose = RandomPoses.Pose(random);
            TargetRig rig = character.Create();
            var result = new RetargetedPose(rig);
            var retargeter = new Retargeter(rig, body, new RetargetOptions { Displacement = true });
            Assert.True(retargeter.TryRetarget(pose, result));
            result.UpdateWorld();

            var actor = new BoneTransform[BoneHierarchy.BoneCount];
            ForwardKinematics.ToWorld(pose, actor, body.Variant);
            Bone?[] sources = ExpectedMap.Sources(character, body.Variant);
            for (int node = 0; node < sources.Length; node++)
            {
                if (sources[node] is not { } source)
                    continue;

                Vector3 way = UnityAxes.ToUnityPosition(actor[(int)source].Position - actor[0].Position) * retargeter.Scale;
                Vector3 expected = result.WorldPositions[rig.HipsNode] + Vector3.Transform(way, character.Facing);
                float error = Vector3.Distance(expected, result.WorldPositions[node]);
                Assert.True(error < 1e-4f * Math.Max(1, retargeter.Scale), $"seed {seed}: {source} at {character.Nodes[node].Name} is off by {error} m");
                Assert.True(result.IsMoved(node));
            }
        }
    }

    [Fact]
    public void The_rotations_are_the_same_with_and_without()
    {
        TargetRig rig = TestRigs.Humanoid();
        BoneTransform[] pose = RandomPoses.Pose(new Random(3));
        RetargetedPose without = Retarget(rig, pose, new RetargetOptions());
        RetargetedPose with = Retarget(rig, pose, new RetargetOptions { Displacement = true });
        Assert.Equal(without.LocalRotations.ToArray(), with.LocalRotations.ToArray());
        Assert.Equal(without.HipsLocalPosition, with.HipsLocalPosition);
    }

    [Fact]
    public void It_is_off_by_default_and_can_be_switched_off()
    {
        TargetRig rig = TestRigs.Humanoid();
        BoneTransform[] pose = RandomPoses.Pose(new Random(3));
        var options = new RetargetOptions();
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault(), options);
        var result = new RetargetedPose(rig);
        foreach (bool displacement in new[] { false, true, false })
        {
            options.Displacement = displacement;
            Assert.True(retargeter.TryRetarget(pose, result));
            for (int node = 0; node < rig.Nodes.Length; node++)
            {
                bool isHips = node == rig.HipsNode;
                Assert.Equal(isHips || (displacement && result.IsDriven(node)), result.IsMoved(node));
                Assert.True(isHips || result.IsMoved(node) || result.LocalPositions[node] == rig.Nodes[node].Position, rig.Nodes[node].Name);
            }
        }
    }

    [Fact]
    public void A_stretched_spine_stretches_a_character_of_half_the_size_by_half()
    {
        TargetRig rig = TestRigs.Humanoid(0.5f);
        BoneTransform[] pose = TestRigs.RestPose(SkeletonBody.GetDefault());
        RetargetedPose rest = Retarget(rig, pose, new RetargetOptions { Displacement = true });
        BoneTransform spine = pose[(int)Bone.Spine1];
        pose[(int)Bone.Spine1] = spine with { Position = spine.Position + new Vector3(0, 6, 0) };
        var options = new RetargetOptions { Displacement = true };
        AssertRaised(0.03f, Retarget(rig, pose, options));

        options.Weights[HumanoidBone.Chest] = 0.5f;
        AssertRaised(0.015f, Retarget(rig, pose, options));

        options.Weights[HumanoidBone.Chest] = 0;
        AssertRaised(0, Retarget(rig, pose, options));

        // The scale of root motion does not change proportions.
        AssertRaised(0.03f, Retarget(rig, pose, new RetargetOptions { Displacement = true, Scale = 3 }));

        void AssertRaised(float height, RetargetedPose raised)
        {
            int head = rig.GetNode(HumanoidBone.Head);
            float hips = raised.WorldPositions[rig.HipsNode].Y - rest.WorldPositions[rig.HipsNode].Y;
            Assert.Equal(height, raised.WorldPositions[head].Y - rest.WorldPositions[head].Y - hips, 1e-5f);
        }
    }

    [Fact]
    public void The_actors_own_skeleton_is_reproduced()
    {
        SkeletonBody body = SkeletonBody.GetDefault();
        RetargetedPose result = Retarget(TestRigs.Actor(body), TestRigs.RestPose(body), new RetargetOptions { Displacement = true });
        for (int node = 1; node < BoneHierarchy.BoneCount; node++)
            RetargetAssert.AssertNear(result.Rig.Nodes[node].Position, result.LocalPositions[node], 1e-6f);
    }

    [Fact]
    public void Nothing_is_allocated()
    {
        TargetRig rig = TestRigs.Humanoid();
        BoneTransform[] pose = RandomPoses.Pose(new Random(3));
        var result = new RetargetedPose(rig);
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault(), new RetargetOptions { Displacement = true });
        Allocations.AssertNone(() =>
        {
            retargeter.TryRetarget(pose, result);
            result.UpdateWorld();
        });
    }

    private static RetargetedPose Retarget(TargetRig rig, BoneTransform[] pose, RetargetOptions options)
    {
        var result = new RetargetedPose(rig);
        Assert.True(new Retargeter(rig, SkeletonBody.GetDefault(), options).TryRetarget(pose, result));
        result.UpdateWorld();
        return result;
    }
}
