using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Drivers;

public sealed class GenericRigDriverTests : SourceFixture
{
    [Theory]
    [InlineData("Robot_")]
    [InlineData("")]
    public void Bones_are_found_by_name_with_and_without_the_prefix_given(string prefix)
    {
        GameObject rig = Build("Robot_", out Dictionary<Bone, Transform> bones);
        GenericRigDriver driver = rig.AddComponent<GenericRigDriver>();
        driver.Prefix = prefix;
        driver.Rebind();
        AddSimulator();
        Loop.RunUntil(() => driver.IsDriving);

        Assert.Empty(driver.MissingBones);
        foreach (Bone bone in BoneHierarchy.Bones)
            AssertNear(driver.Performer!.GetRotation(bone), bones[bone].rotation);

        // With the performer's own sizes, joints are where the performer's are.
        Assert.True((driver.Performer!.GetPosition(Bone.LeftHand) - bones[Bone.LeftHand].position).magnitude < 0.01f);
    }

    [Fact]
    public void An_explicit_binding_wins_over_a_name()
    {
        GameObject rig = Build("x:", out Dictionary<Bone, Transform> bones);
        bones[Bone.Head].name = "Skull";
        GenericRigDriver driver = rig.AddComponent<GenericRigDriver>();
        driver.Bindings.Add(new BoneBinding { Bone = Bone.Head, Transform = bones[Bone.Head] });
        driver.BoneWeights.Add(new StreamBoneWeight { Bone = Bone.LeftArm, Weight = 0 });
        driver.Rebind();
        AddSimulator();
        Loop.RunUntil(() => driver.IsDriving);
        AssertNear(driver.Performer!.GetRotation(Bone.Head), bones[Bone.Head].rotation);
        AssertNear(Quaternion.identity, bones[Bone.LeftArm].localRotation);
    }

    [Fact]
    public void Missing_hips_are_explained()
    {
        GenericRigDriver driver = new GameObject("Crate").AddComponent<GenericRigDriver>();
        driver.Prefix = "Robot_";
        Loop.Frame();
        Assert.Contains("Prefix", driver.Problem, StringComparison.Ordinal);
        Assert.Contains("Crate", driver.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_skins_rest_pose_wins_over_the_current_pose()
    {
        GameObject rig = Build("", out Dictionary<Bone, Transform> bones);
        SkinnedMeshRenderer skin = rig.AddComponent<SkinnedMeshRenderer>();
        Transform[] all = [.. bones.Values];
        skin.bones = all;
        skin.sharedMesh = new Mesh { bindposes = [.. all.Select(bone => bone.worldToLocalMatrix * rig.transform.localToWorldMatrix)] };
        bones[Bone.LeftArm].localRotation = Quaternion.Euler(0, 0, 80);
        GenericRigDriver driver = rig.AddComponent<GenericRigDriver>();
        AddSimulator();
        Loop.RunUntil(() => driver.IsDriving);
        Assert.Equal(string.Empty, driver.RestPoseNote);
        AssertNear(driver.Performer!.GetRotation(Bone.LeftArm), bones[Bone.LeftArm].rotation);
    }

    private static GameObject Build(string prefix, out Dictionary<Bone, Transform> bones)
    {
        var root = new GameObject("Rig");
        bones = [];
        SkeletonBody body = SkeletonBody.GetDefault();
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Transform added = new GameObject(prefix + BoneHierarchy.GetName(bone)).transform;
            added.SetParent(BoneHierarchy.GetParent(bone) is { } parent ? bones[parent] : root.transform, worldPositionStays: false);
            added.localPosition = body.GetOffset(bone).ToUnityPosition();
            bones.Add(bone, added);
        }

        return root;
    }

    private static void AssertNear(Quaternion expected, Quaternion actual) => Assert.True(Quaternion.Angle(expected, actual) < 0.1f, $"{expected} {actual}");
}
