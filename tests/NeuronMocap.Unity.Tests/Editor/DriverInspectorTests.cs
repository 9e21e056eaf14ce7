using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Editor;

public sealed class DriverInspectorTests : IDisposable
{
    private readonly EditorWorld _world = new(play: true);

    public void Dispose() => _world.Dispose();

    [Theory]
    [InlineData(typeof(HumanoidDriver))]
    [InlineData(typeof(GenericRigDriver))]
    public void The_inspector_explains_why_a_figure_moves_or_not(Type type)
    {
        var driver = (FigureDriver)HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent(type);
        UnityEditor.Editor inspector = _world.Inspect(driver);
        _world.Loop.Frame();
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.Error), EditorWorld.DotOf("The figure does not move"));
        Assert.Contains("No mocap source found", Assert.Single(EditorWorld.Labels("HelpBox")), StringComparison.Ordinal);

        driver.Source = Stage.AddSimulator();
        _world.Loop.RunUntil(() => driver.IsDriving);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.Good), EditorWorld.DotOf($"Follows {driver.Performer}"));

        // The rest pose is already captured, so a check would examine the performer's pose.
        Assert.DoesNotContain(FigureDriverEditor.CheckAgain, EditorWorld.Labels("Button"));

        driver.enabled = false;
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.None), EditorWorld.DotOf("Disabled"));
    }

    [Fact]
    public void A_missing_performer_is_named_with_the_present_ones()
    {
        HumanoidDriver driver = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<HumanoidDriver>();
        (driver.Source, driver.PerformerIndex) = (Stage.AddSimulator(performers: 2), 7);
        _world.Loop.RunUntil(() => Stage.IsLive(driver.Source, performers: 2));
        _world.Loop.Frame();

        ImmediateGui.Draw(_world.Inspect(driver).OnInspectorGUI);

        Assert.Equal(Dot(Severity.Error), EditorWorld.DotOf("The figure does not move"));
        string advice = Assert.Single(EditorWorld.Labels("HelpBox"));
        Assert.Contains("No performer 7", advice, StringComparison.Ordinal);
        Assert.All(driver.Source.Performers, performer => Assert.Contains($"{performer}", advice, StringComparison.Ordinal));
    }

    [Fact]
    public void Edit_mode_explains_when_the_figure_moves()
    {
        using var world = new EditorWorld();
        HumanoidDriver driver = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<HumanoidDriver>();

        ImmediateGui.Draw(world.Inspect(driver).OnInspectorGUI);

        Assert.Equal(Dot(Severity.None), EditorWorld.DotOf("Moves in play mode"));
        Assert.Contains(FigureDriverEditor.CheckAgain, EditorWorld.Labels("Button"));
    }

    [Fact]
    public void Irrelevant_fields_are_hidden()
    {
        using var world = new EditorWorld();
        HumanoidDriver driver = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<HumanoidDriver>();
        UnityEditor.Editor inspector = world.Inspect(driver);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Contains("Performer Index", EditorWorld.Labels("Property"));
        Assert.DoesNotContain("Performer Name", EditorWorld.Labels("Property"));

        ImmediateGui.Set(inspector.OnInspectorGUI, "Performer Choice", PerformerChoice.ByName);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.DoesNotContain("Performer Index", EditorWorld.Labels("Property"));
        Assert.Contains("Performer Name", EditorWorld.Labels("Property"));
    }

    [Fact]
    public void The_first_bone_weight_of_a_list_is_one()
    {
        using var world = new EditorWorld();
        HumanoidDriver humanoid = new GameObject("Humanoid").AddComponent<HumanoidDriver>();
        GenericRigDriver generic = new GameObject("Generic").AddComponent<GenericRigDriver>();

        ImmediateGui.Set(world.Inspect(humanoid).OnInspectorGUI, "Bone Weights", 1);
        ImmediateGui.Set(world.Inspect(generic).OnInspectorGUI, "Bone Weights", 2);
        Assert.Equal([1f], humanoid.BoneWeights.Select(static bone => bone.Weight));
        Assert.Equal([1f, 1f], generic.BoneWeights.Select(static bone => bone.Weight));

        // Unity fills further elements with the last one, which the user has set.
        humanoid.BoneWeights[0] = new HumanoidBoneWeight { Bone = HumanoidBone.Head, Weight = 0.25f };
        ImmediateGui.Set(world.Inspect(humanoid).OnInspectorGUI, "Bone Weights", 2);
        Assert.Equal([0.25f, 0.25f], humanoid.BoneWeights.Select(static bone => bone.Weight));
    }

    [Fact]
    public void Names_of_bones_that_are_edited_while_the_figure_moves_take_effect_in_the_next_frame()
    {
        GameObject rig = GenericRig.Build("A_", out Dictionary<Bone, Transform> first);
        GenericRig.Build("B_", out Dictionary<Bone, Transform> second);
        second[Bone.Hips].SetParent(rig.transform, worldPositionStays: false);
        GenericRigDriver driver = rig.AddComponent<GenericRigDriver>();
        (driver.Prefix, driver.Source) = ("A_", Stage.AddSimulator());
        driver.Rebind();
        _world.Loop.RunUntil(() => driver.IsDriving);
        UnityEditor.Editor inspector = _world.Inspect(driver);
        Assert.Equal(first[Bone.Hips], HipsOf(driver));

        ImmediateGui.Set(inspector.OnInspectorGUI, "Prefix", "B_");
        _world.Loop.Frame();
        Assert.Equal(second[Bone.Hips], HipsOf(driver));
        Assert.True(Quaternion.Angle(Quaternion.identity, first[Bone.LeftArm].localRotation) < 0.1f, "The old bones keep their last pose.");

        ImmediateGui.Set(inspector.OnInspectorGUI, "Bindings", new List<BoneBinding> { new() { Bone = Bone.Head, Transform = second[Bone.Neck1] } });
        _world.Loop.Frame();
        Assert.Equal([Bone.Neck1], driver.MissingBones);

        // Other fields change often, such as with a slider, and need no new rig.
        TargetRig? bound = driver.TargetRig;
        ImmediateGui.Set(inspector.OnInspectorGUI, "Weight", 0.5f);
        _world.Loop.Frame();
        Assert.Same(bound, driver.TargetRig);
    }

    [Fact]
    public void Smoothing_shows_its_delay_and_in_play_mode_the_noise()
    {
        HumanoidDriver driver = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<HumanoidDriver>();
        UnityEditor.Editor inspector = _world.Inspect(driver);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.DoesNotContain("Part Smoothing", EditorWorld.Labels("Property"));
        Assert.DoesNotContain("Arms Smoothing", EditorWorld.Labels("Label"));

        ImmediateGui.Set(inspector.OnInspectorGUI, "Smoothing", true);
        driver.PartSmoothing.Set(BodyParts.Arms, new SmoothingAmount(2, 1));
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Contains("Part Smoothing", EditorWorld.Labels("Property"));
        Assert.Equal("delay 80 ms at rest, 31 ms at 180 degrees/s", EditorWorld.Find("Arms Smoothing").Value);

        driver.Source = Stage.AddSimulator();
        _world.Loop.RunUntil(() => driver.IsDriving);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Matches(@"at 180 degrees/s; noise \d+\.\d\d degrees before, \d+\.\d\d after$", EditorWorld.Find("Arms Smoothing").Value);
    }

    private static Transform HipsOf(FigureDriver driver) => driver.FindRig(out _)!.Nodes[driver.TargetRig!.HipsNode];

    private static Color Dot(Severity severity) => ReportGui.ColorOf(severity, isDarkSkin: true);
}
