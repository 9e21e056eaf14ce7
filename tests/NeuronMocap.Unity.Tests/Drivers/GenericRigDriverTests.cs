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
        GameObject rig = GenericRig.Build("Robot_", out Dictionary<Bone, Transform> bones);
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
        GameObject rig = GenericRig.Build("x:", out Dictionary<Bone, Transform> bones);
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

    // As in rigs of Daz 3D and Character Creator.
    [Fact]
    public void Of_hip_and_pelvis_the_one_that_carries_legs_and_spine_is_driven()
    {
        GameObject rig = GenericRig.Build("", out Dictionary<Bone, Transform> bones);
        bones[Bone.Hips].name = "hip";
        Transform pelvis = new GameObject("pelvis").transform;
        pelvis.SetParent(bones[Bone.Hips], worldPositionStays: false);
        bones[Bone.LeftUpLeg].SetParent(pelvis);
        bones[Bone.RightUpLeg].SetParent(pelvis);
        GenericRigDriver driver = rig.AddComponent<GenericRigDriver>();
        AddSimulator();
        Loop.RunUntil(() => driver.IsDriving);

        Assert.True((driver.Performer!.GetPosition(Bone.Head) - bones[Bone.Head].position).magnitude < 0.01f, "The trunk stayed behind.");
        Assert.True((driver.Performer.GetPosition(Bone.LeftFoot) - bones[Bone.LeftFoot].position).magnitude < 0.01f, "The legs stayed behind.");
        AssertNear(driver.Performer.GetRotation(Bone.Hips), bones[Bone.Hips].rotation);
        AssertNear(Quaternion.identity, pelvis.localRotation);
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
        GameObject rig = GenericRig.Build("", out Dictionary<Bone, Transform> bones);
        GenericRig.BindSkin(rig, bones);
        bones[Bone.LeftArm].localRotation = Quaternion.Euler(0, 0, 80);
        GenericRigDriver driver = rig.AddComponent<GenericRigDriver>();
        AddSimulator();
        Loop.RunUntil(() => driver.IsDriving);
        Assert.Equal(string.Empty, driver.RestPoseNote);
        AssertNear(driver.Performer!.GetRotation(Bone.LeftArm), bones[Bone.LeftArm].rotation);
    }

    [Theory]
    [InlineData(RestPoseChoice.BindPose, false, 45)]
    [InlineData(RestPoseChoice.BindPose, true, 45)]
    [InlineData(RestPoseChoice.AsItStands, false, 45)]
    [InlineData(RestPoseChoice.AsItStands, true, 0)]
    [InlineData(RestPoseChoice.TPose, false, 0)]
    [InlineData(RestPoseChoice.TPose, true, 0)]
    public void The_rest_pose_of_a_rig_bound_in_an_A_pose_can_be_chosen(RestPoseChoice choice, bool standsInTPose, float degreesOff)
    {
        GameObject rig = GenericRig.BuildInAPose(out Dictionary<Bone, Transform> bones);
        if (standsInTPose)
            GenericRig.LowerArms(bones, 0);

        GenericRigDriver driver = rig.AddComponent<GenericRigDriver>();
        driver.RestPoseChoice = choice;
        AddSimulator();
        Loop.RunUntil(() => driver.IsDriving);
        foreach ((Bone from, Bone to) in new[] { (Bone.LeftArm, Bone.LeftForeArm), (Bone.RightForeArm, Bone.RightHand) })
        {
            Vector3 way = driver.Performer!.GetPosition(to) - driver.Performer.GetPosition(from);
            Assert.Equal(degreesOff, Vector3.Angle(way, bones[to].position - bones[from].position), 2f);
        }

        Assert.Equal(degreesOff > 0, driver.RestPoseNote.Contains("T Pose", StringComparison.Ordinal));
    }

    [Fact]
    public void A_change_of_the_rest_pose_takes_effect_at_once()
    {
        GameObject rig = GenericRig.BuildInAPose(out Dictionary<Bone, Transform> bones);
        GenericRigDriver driver = rig.AddComponent<GenericRigDriver>();
        AddSimulator(motion: SimulatedMotion.TPose);
        Loop.RunUntil(() => driver.IsDriving);
        float lowered = bones[Bone.LeftHand].position.y;

        driver.RestPoseChoice = RestPoseChoice.TPose;
        Loop.Frame();
        Assert.True(bones[Bone.LeftHand].position.y > lowered + 0.2f, "The arm did not rise.");
    }

    private static void AssertNear(Quaternion expected, Quaternion actual) => Assert.True(Quaternion.Angle(expected, actual) < 0.1f, $"{expected} {actual}");
}
