using NeuronMocap.Skeleton;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Tests.Drivers;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

public class RigValidatorTests
{
    [Fact]
    public void A_figure_in_a_T_pose_is_valid()
    {
        using var world = new EditorWorld();
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        UnityEditor.Editor inspector = world.Inspect(figure.Root.AddComponent<HumanoidDriver>());

        ImmediateGui.Draw(inspector.OnInspectorGUI);

        Assert.DoesNotContain(((FigureDriverEditor)inspector).Problems, static problem => problem.Severity >= Severity.Warning);
        Assert.Contains("The rig is right", EditorWorld.Labels("Label"));
    }

    [Fact]
    public void A_missing_Animator_is_added_with_a_click_and_then_its_avatar_is_missing()
    {
        using var world = new EditorWorld();
        HumanoidDriver driver = new GameObject("Figure").AddComponent<HumanoidDriver>();
        UnityEditor.Editor inspector = world.Inspect(driver);

        ImmediateGui.Click(inspector.OnInspectorGUI, "Add an Animator");

        Assert.NotNull(driver.GetComponent<Animator>());
        Assert.Contains("no avatar", Assert.Single(HumanoidCheck.Examine(driver)).Text, StringComparison.Ordinal);
    }

    [Fact]
    public void A_figure_that_is_built_in_play_mode_has_no_fault()
    {
        using var world = new EditorWorld();
        CreateMenu.CreateQuickStart();
        HumanoidDriver driver = Object.FindObjectOfType<HumanoidDriver>()!;

        ImmediateGui.Draw(world.Inspect(driver).OnInspectorGUI);

        RigProblem row = Assert.Single(HumanoidCheck.Examine(driver));
        Assert.Equal((Severity.None, HumanoidCheck.BuiltLater, null), (row.Severity, row.Text, row.FixLabel));
        Assert.DoesNotContain("Add an Animator", EditorWorld.Labels("Button"));
        Assert.DoesNotContain(EditorWorld.Controls, static control => control is { Kind: "HelpBox", Value: "Error" });
    }

    [Fact]
    public void An_Animator_above_is_assigned_with_Undo()
    {
        using var world = new EditorWorld();
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        var child = new GameObject("Mocap");
        child.transform.SetParent(figure.Root.transform, false);
        HumanoidDriver driver = child.AddComponent<HumanoidDriver>();

        ImmediateGui.Click(world.Inspect(driver).OnInspectorGUI, $"Assign {figure.Root.name}");
        Assert.Same(figure.Animator, driver.Animator);

        Undo.PerformUndo();
        Assert.True(driver.Animator == null);
    }

    [Fact]
    public void A_generic_model_is_imported_as_Humanoid_with_a_click()
    {
        using var world = new EditorWorld();
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        Avatar human = figure.Avatar;
        Avatar generic = AvatarBuilder.BuildGenericAvatar(figure.Root, "");
        figure.Animator.avatar = generic;
        AssetDatabase.Add("Assets/Figure.fbx", generic);
        ModelImporter importer = AssetImporter.Add("Assets/Figure.fbx", new ModelImporter());
        importer.Imported = () => figure.Animator.avatar = human;
        HumanoidDriver driver = figure.Root.AddComponent<HumanoidDriver>();
        Assert.Equal(Severity.Error, HumanoidCheck.Examine(driver)[0].Severity);

        ImmediateGui.Click(world.Inspect(driver).OnInspectorGUI, "Import the Model as Humanoid");

        Assert.Equal((ModelImporterAnimationType.Human, 1), (importer.animationType, importer.Imports));
        Assert.DoesNotContain(HumanoidCheck.Examine(driver), static problem => problem.Severity == Severity.Error);
    }

    [Fact]
    public void Root_motion_under_a_controller_is_switched_off_with_a_click()
    {
        using var world = new EditorWorld();
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        figure.Animator.runtimeAnimatorController = new RuntimeAnimatorController();
        figure.Animator.applyRootMotion = true;

        ImmediateGui.Click(world.Inspect(figure.Root.AddComponent<HumanoidDriver>()).OnInspectorGUI, "Switch Root Motion Off");
        Assert.False(figure.Animator.applyRootMotion);

        Undo.PerformUndo();
        Assert.True(figure.Animator.applyRootMotion);
    }

    [Fact]
    public void A_generic_rig_whose_arms_hang_is_put_into_the_T_pose_with_a_click()
    {
        using var world = new EditorWorld();
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        figure.Renderer.sharedMesh = null;
        Transform arm = figure.GetBone(Bone.LeftArm);
        arm.localRotation = Quaternion.Euler(0, 0, 70);
        GenericRigDriver driver = figure.Root.AddComponent<GenericRigDriver>();
        Assert.Contains(GenericCheck.Examine(driver), static problem => problem.FixLabel == RigIssues.FixLabel);

        ImmediateGui.Click(world.Inspect(driver).OnInspectorGUI, RigIssues.FixLabel);

        Assert.DoesNotContain(GenericCheck.Examine(driver), static problem => problem.Severity >= Severity.Warning);
        Assert.True(Quaternion.Angle(arm.localRotation, Quaternion.identity) < 12);
        Undo.PerformUndo();
        Assert.True(Quaternion.Angle(arm.localRotation, Quaternion.Euler(0, 0, 70)) < 0.1f);
    }

    [Fact]
    public void Bones_that_are_not_below_the_hips_are_reported()
    {
        using var world = new EditorWorld();
        GameObject rig = GenericRig.Build("", out Dictionary<Bone, Transform> bones);
        bones[Bone.Spine].SetParent(rig.transform);
        UnityEditor.Editor inspector = world.Inspect(rig.AddComponent<GenericRigDriver>());

        ImmediateGui.Draw(inspector.OnInspectorGUI);

        GuiControl warning = EditorWorld.Find("Spine, which follows Spine, is not below Hips");
        Assert.Equal(("HelpBox", "Warning"), (warning.Kind, warning.Value));
    }

    [Fact]
    public void A_wrong_prefix_is_replaced_with_a_click()
    {
        using var world = new EditorWorld();
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        GenericRigDriver driver = figure.Root.AddComponent<GenericRigDriver>();
        foreach (Transform bone in figure.Root.GetComponentsInChildren<Transform>(true))
            bone.name = $"Suit_{bone.name}";

        driver.Prefix = "Robot_";
        RigProblem problem = Assert.Single(GenericCheck.Examine(driver));

        ImmediateGui.Click(world.Inspect(driver).OnInspectorGUI, problem.FixLabel!);

        Assert.DoesNotContain(GenericCheck.Examine(driver), static found => found.Severity == Severity.Error);
    }
}
