using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Retargeting;

namespace NeuronMocap.Data.Tests.Retargeting;

// A take recorded with a suit. It is not part of the repository.
public sealed class RetargetTakeTests
{
    [Fact]
    public void Every_frame_of_a_recorded_take_matches_the_reference()
    {
        BvhDocument document = BvhDocument.Load(Fixtures.Require("test-take", "test.bvh"));
        Assert.True(BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason), reason);
        SkeletonBody body = map.GetBody();
        RandomRig[] characters = [.. Enumerable.Range(0, 8).Select(seed => new RandomRig(seed, (RigScales)(seed % 4)))];
        Retargeter[] retargeters = [.. characters.Select(character => new Retargeter(character.Create(), body))];
        RetargetedPose[] results = [.. retargeters.Select(retargeter => new RetargetedPose(retargeter.Rig))];
        ReferenceRetargeter[] references =
            [.. characters.Select(character => new ReferenceRetargeter(character.Nodes, ExpectedMap.Sources(character, body.Variant), character.Facing))];
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            map.CopyLocalTransforms(frame, pose);
            int i = frame % characters.Length;
            Assert.True(retargeters[i].TryRetarget(pose, results[i]));
            results[i].UpdateWorld();
            references[i].Retarget(pose, body);
            RetargeterReferenceTests.AssertSame(references[i], results[i], $"frame {frame}, character {i}");
        }

        Assert.Equal(2156, document.FrameCount);
    }

    // The character is as tall as the actor, so its feet are where the actor's are.
    [Fact]
    public void The_actors_own_skeleton_matches_the_take()
    {
        BvhDocument document = BvhDocument.Load(Fixtures.Require("test-take", "test.bvh"));
        Assert.True(BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason), reason);
        SkeletonBody body = map.GetBody();
        TargetRig rig = TestRigs.Actor(body);
        var retargeter = new Retargeter(rig, body);
        var result = new RetargetedPose(rig);
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        float offset = (rig.HipsHeight * 100) - HeightOf(body);
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            map.CopyLocalTransforms(frame, pose);
            Assert.True(retargeter.TryRetarget(pose, result));
            result.UpdateWorld();
            ForwardKinematics.ToWorld(pose, pose, body.Variant);
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                Vector3 expected = UnityAxes.ToUnityPosition(pose[(int)bone].Position + new Vector3(0, offset, 0));
                Assert.True(Vector3.Distance(expected, result.WorldPositions[(int)bone]) < 1e-4f, $"frame {frame}, {bone}");
            }
        }
    }

    private static float HeightOf(SkeletonBody body)
    {
        BoneTransform[] rest = TestRigs.RestPose(body);
        ForwardKinematics.ToWorld(rest, rest, body.Variant);
        return rest[0].Position.Y - JointPositions.GetLowest(rest, body).Y;
    }
}
