using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Drivers;

// A performer whose forearm and chest are longer than those of the figure.
public sealed class DisplacementTests : SourceFixture
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Bones_of_a_generic_rig_are_where_the_performers_are_if_asked_for(bool displacement)
    {
        GameObject rig = GenericRig.Build("", out Dictionary<Bone, Transform> bones);
        GenericRigDriver driver = rig.AddComponent<GenericRigDriver>();
        driver.Displacement = displacement;
        AddStretchedPerformer();
        Loop.RunUntil(() => driver.IsDriving);

        Vector3 way = driver.Performer!.GetPosition(Bone.LeftHand) - driver.Performer.GetPosition(Bone.Hips);
        float off = (bones[Bone.LeftHand].position - bones[Bone.Hips].position - way).magnitude;
        Assert.True(displacement ? off < 0.001f : off > 0.05f, $"{off}");
    }

    [Fact]
    public void A_Humanoid_takes_over_the_proportions_at_its_own_size_and_returns_to_its_own()
    {
        TestFigure figure = TestFigure.Build("Figure", size: 0.5f);
        Dictionary<Transform, Vector3> rest = figure.Rest.Keys.ToDictionary(static bone => bone, static bone => bone.localPosition);
        HumanoidDriver driver = figure.Drive(AddStretchedPerformer());
        driver.Displacement = true;
        Loop.RunUntil(() => driver.IsDriving);
        foreach (Bone bone in new[] { Bone.Spine2, Bone.Head, Bone.LeftHand, Bone.RightFoot, Bone.LeftHandIndex2 })
        {
            Vector3 way = driver.Performer!.GetPosition(bone) - driver.Performer.GetPosition(Bone.Hips);
            Vector3 own = figure.Root.transform.InverseTransformPoint(figure[bone].position) - figure.Root.transform.InverseTransformPoint(figure[Bone.Hips].position);
            Assert.True((own - (way * 0.5f)).magnitude < 0.001f, $"{bone}: {own} {way}");
        }

        driver.Displacement = false;
        Loop.Frame();
        foreach (KeyValuePair<Transform, Vector3> bone in rest.Where(bone => bone.Key != figure[Bone.Hips]))
            Assert.True((bone.Key.localPosition - bone.Value).magnitude < 0.0001f, bone.Key.name);
    }

    [Fact]
    public void Half_the_weight_is_half_the_way()
    {
        GameObject rig = GenericRig.Build("", out Dictionary<Bone, Transform> bones);
        Vector3 rest = bones[Bone.LeftHand].localPosition;
        GenericRigDriver driver = rig.AddComponent<GenericRigDriver>();
        driver.Displacement = true;
        AddStretchedPerformer();
        Loop.RunUntil(() => driver.IsDriving);
        Vector3 whole = bones[Bone.LeftHand].localPosition;

        driver.Weight = 0.5f;
        Loop.Frame();
        Assert.True((bones[Bone.LeftHand].localPosition - ((rest + whole) / 2)).magnitude < 0.0001f, $"{bones[Bone.LeftHand].localPosition}");
    }

    [Fact]
    public void Frames_allocate_nothing_with_every_option_on()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(AddStretchedPerformer());
        (driver.Displacement, driver.FootPlanting, driver.Weight) = (true, true, 0.7f);
        figure.Animator.Animating = () => figure[Bone.LeftArm].localRotation = Quaternion.identity;
        GenericRigDriver generic = GenericRig.BuildInAPose(out _).AddComponent<GenericRigDriver>();
        (generic.Displacement, generic.FootPlanting, generic.Weight, generic.RestPoseChoice) = (true, true, 0.7f, RestPoseChoice.TPose);
        Loop.RunUntil(() => driver.IsDriving && generic.IsDriving);
        FrameAllocations.AssertNone(Loop);
        Assert.True(driver.IsDriving && generic.IsDriving);
    }

    private MocapSource AddStretchedPerformer() => Add(Serve(new ValuesSource(static (_, layout, values) =>
    {
        values[layout.GetPositionIndex(Bone.LeftHand)] += 8;
        values[layout.GetPositionIndex(Bone.Spine2) + 1] += 5;
        values[layout.GetRotationIndex(Bone.LeftArm)] = 30;
    })));
}
