using System.Numerics;
using System.Text.Json;
using NeuronMocap.Skeleton;

namespace NeuronMocap.View.Tests.Infrastructure;

/// <summary>Needs no browser, so that this project always has tests.</summary>
public sealed class JointsTests
{
    [Fact]
    public void The_largest_distance_is_in_metres()
    {
        var world = new BoneTransform[BoneHierarchy.BoneCount];
        world[(int)Bone.Head] = new BoneTransform(new Vector3(10, 170, 20), Quaternion.Identity);
        world[(int)Bone.LeftHand] = new BoneTransform(new Vector3(80, 140, 0), Quaternion.Identity);
        JsonElement joints = JsonSerializer.SerializeToElement(BoneHierarchy.Bones.ToArray().ToDictionary(
            static bone => BoneHierarchy.GetName(bone),
            static bone => bone == Bone.Head ? [0.1f, 1.7f, 0.2f] : bone == Bone.LeftHand ? [0.8f, 1.4f, 0.25f] : new float[3]));

        Assert.Equal(0.25f, Joints.Distance(joints, world), 1e-5f);
    }
}
