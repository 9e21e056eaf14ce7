using NeuronMocap.Skeleton;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

public class PhysicsCheckTests
{
    [Fact]
    public void The_menu_adds_colliders_as_one_Undo_step()
    {
        const string Entry = "GameObject/NeuronMocap/Add Colliders";
        using var world = new EditorWorld();
        GameObject figure = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root;
        Selection.objects = [figure];
        Assert.False(MenuItems.Execute(Entry));

        HumanoidDriver driver = figure.AddComponent<HumanoidDriver>();
        Assert.True(MenuItems.Execute(Entry));
        Assert.InRange(figure.GetComponentsInChildren<Rigidbody>(true).Length, 15, 20);
        Assert.Equal(DriveTime.Physics, driver.DriveTime);
        Assert.Empty(PhysicsCheck.Examine(driver));

        Undo.PerformUndo();
        Assert.Empty(figure.GetComponentsInChildren<Rigidbody>(true));
        Assert.Empty(figure.GetComponentsInChildren<CapsuleCollider>(true));
        Assert.Equal(DriveTime.LateUpdate, driver.DriveTime);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void Without_a_figure_the_menu_says_why()
    {
        using var world = new EditorWorld();
        var empty = new GameObject("Empty");
        empty.AddComponent<HumanoidDriver>();
        Selection.objects = [empty];

        MenuItems.Execute("GameObject/NeuronMocap/Add Colliders");

        Assert.Contains("No Animator", Assert.Single(ConsoleLog.Entries).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Missing_bodies_and_the_wrong_drive_time_are_fixed_by_a_click()
    {
        using var world = new EditorWorld();
        HumanoidDriver driver = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<HumanoidDriver>();
        Assert.Empty(PhysicsCheck.Examine(driver));

        driver.DriveTime = DriveTime.Physics;
        UnityEditor.Editor inspector = world.Inspect(driver);
        ImmediateGui.Click(inspector.OnInspectorGUI, PhysicsCheck.AddColliders);
        Assert.Empty(PhysicsCheck.Examine(driver));

        driver.DriveTime = DriveTime.Update;
        RigProblem wrong = Assert.Single(PhysicsCheck.Examine(driver));
        Assert.Equal(PhysicsCheck.UsePhysics, wrong.FixLabel);
        wrong.Fix!();
        Assert.Equal(DriveTime.Physics, driver.DriveTime);
    }

    [Fact]
    public void A_body_that_is_not_kinematic_is_an_error()
    {
        using var world = new EditorWorld();
        HumanoidDriver driver = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<HumanoidDriver>();
        driver.DriveTime = DriveTime.Physics;
        FigureColliders.Add(driver);
        Rigidbody body = driver.GetComponentInChildren<Rigidbody>(true);
        body.isKinematic = false;

        RigProblem problem = Assert.Single(PhysicsCheck.Examine(driver));
        Assert.Equal(Severity.Error, problem.Severity);
        Assert.Contains(body.name, problem.Text, StringComparison.Ordinal);
        problem.Fix!();
        Assert.True(body.isKinematic);

        Undo.PerformUndo();
        Assert.False(body.isKinematic);
    }
}
