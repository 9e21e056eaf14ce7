using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class RetargetedPoseTests
{
    [Fact]
    public void A_pose_starts_and_resets_at_rest()
    {
        TargetRig rig = new RandomRig(1, RigScales.Signs).Create();
        var pose = new RetargetedPose(rig);
        AssertRest(pose);
        Assert.True(new Retargeter(rig, SkeletonBody.GetDefault()).TryRetarget(RandomPoses.Pose(new Random(1)), pose));
        Assert.True(pose.IsDriven(rig.HipsNode));
        pose.Reset();
        AssertRest(pose);
    }

    // Corrections of legs turn one node after the other in the world, and read the resulting positions.
    [Fact]
    public void Turning_a_node_moves_its_descendants()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            var random = new Random(seed);
            TargetRig rig = new RandomRig(seed, (RigScales)(seed % 4)).Create();
            var pose = new RetargetedPose(rig);
            Assert.True(new Retargeter(rig, SkeletonBody.GetDefault()).TryRetarget(RandomPoses.Pose(random), pose));
            pose.UpdateWorld();
            for (int i = 0; i < 5; i++)
            {
                int node = random.Next(rig.Nodes.Length);
                Quaternion[] before = pose.LocalRotations.ToArray();
                Quaternion turn = RandomPoses.Turn(random);
                pose.SetWorldRotation(node, turn);
                Assert.True(Affine.Turned(turn).AngleTo(pose.WorldRotations[node]) < 2e-6, $"seed {seed}, node {node}");
                Assert.True(Quaternion.Dot(before[node], pose.LocalRotations[node]) >= 0);
                before[node] = pose.LocalRotations[node];
                Assert.Equal(before, pose.LocalRotations.ToArray());
                AssertUpToDate(pose, $"seed {seed}, node {node}");
            }
        }
    }

    [Fact]
    public void The_hips_are_placed_in_the_root()
    {
        for (int seed = 0; seed < 100; seed++)
        {
            TargetRig rig = new RandomRig(seed, (RigScales)(seed % 4)).Create();
            var pose = new RetargetedPose(rig);
            Assert.True(new Retargeter(rig, SkeletonBody.GetDefault()).TryRetarget(RandomPoses.Pose(new Random(seed)), pose));
            pose.UpdateWorld();
            Vector3 place = RandomPoses.Direction(new Random(seed)) * 2;
            pose.SetHipsWorldPosition(place);
            Assert.True(Vector3.Distance(place, pose.WorldPositions[rig.HipsNode]) < 1e-5f, $"seed {seed}");
            AssertUpToDate(pose, $"seed {seed}");
        }
    }

    private static void AssertUpToDate(RetargetedPose pose, string where)
    {
        Vector3[] positions = pose.WorldPositions.ToArray();
        Quaternion[] rotations = pose.WorldRotations.ToArray();
        pose.UpdateWorld();
        for (int node = 0; node < positions.Length; node++)
            Assert.True(Vector3.Distance(positions[node], pose.WorldPositions[node]) < 1e-5f, $"{where}, node {node}");
        Assert.True(rotations.AsSpan().SequenceEqual(pose.WorldRotations), where);
    }

    private static void AssertRest(RetargetedPose pose)
    {
        TargetRig rig = pose.Rig;
        Assert.Equal(rig.Nodes.ToArray().Select(node => node.Rotation), pose.LocalRotations.ToArray());
        Assert.Equal(rig.Nodes[rig.HipsNode].Position, pose.HipsLocalPosition);
        Assert.Equal(rig.RestPositions.ToArray(), pose.WorldPositions.ToArray());
        Assert.Equal(rig.RestRotations.ToArray(), pose.WorldRotations.ToArray());
        Assert.DoesNotContain(true, Enumerable.Range(0, rig.Nodes.Length).Select(pose.IsDriven));
    }
}
