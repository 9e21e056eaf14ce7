using NeuronMocap.Retargeting;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Tests.Drivers;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

// A generic rig whose skin is bound in an A-pose.
public sealed class RestPoseTests : IDisposable
{
    private readonly EditorWorld _world = new();

    public void Dispose() => _world.Dispose();

    [Fact]
    public void The_check_offers_the_T_pose_and_keeps_the_transforms()
    {
        GenericRigDriver driver = AddDriver(out Dictionary<Bone, Transform> bones);
        RigProblem problem = Assert.Single(GenericCheck.Examine(driver), static problem => problem.FixLabel is not null);
        Assert.Equal((Severity.Warning, GenericCheck.UseTPose), (problem.Severity, problem.FixLabel));

        ImmediateGui.Click(_world.Inspect(driver).OnInspectorGUI, GenericCheck.UseTPose);
        Assert.Equal(RestPoseChoice.TPose, driver.RestPoseChoice);
        Assert.DoesNotContain(GenericCheck.Examine(driver), static problem => problem.Severity >= Severity.Warning);
        Assert.Equal(45, Quaternion.Angle(Quaternion.identity, bones[Bone.LeftArm].localRotation), 0.1f);

        Undo.PerformUndo();
        Assert.Equal(RestPoseChoice.BindPose, driver.RestPoseChoice);
    }

    [Fact]
    public void A_pose_in_the_scene_is_corrected_in_the_scene()
    {
        GenericRigDriver driver = AddDriver(out Dictionary<Bone, Transform> bones);
        driver.RestPoseChoice = RestPoseChoice.AsItStands;
        ImmediateGui.Click(_world.Inspect(driver).OnInspectorGUI, RigIssues.FixLabel);
        Assert.Equal(RestPoseChoice.AsItStands, driver.RestPoseChoice);
        Assert.True(Quaternion.Angle(Quaternion.identity, bones[Bone.LeftArm].localRotation) < 2, "The arm was not raised.");
    }

    [Theory]
    [InlineData(RestPoseChoice.BindPose, 45)]
    [InlineData(RestPoseChoice.TPose, 0)]
    public void The_preview_shows_the_chosen_rest_pose(RestPoseChoice choice, float degrees)
    {
        GenericRigDriver driver = AddDriver(out _);
        driver.RestPoseChoice = choice;
        UnityEditor.Editor inspector = _world.Inspect(driver);
        ImmediateGui.Draw(inspector.OnInspectorGUI);

        GenericCheck.Examine(driver, out TargetRig? rest);
        var view = new PreviewView { Center = new Vector3(0, 0.95f, 0) };
        (Vector2 from, Vector2 to, _) = RestLines.Of(rest!, view, ImmediateGui.FreeRect).Single(static line => line.Bone == Bone.LeftForeArm);
        Assert.Equal(degrees, Mathf.Atan2(to.y - from.y, Mathf.Abs(to.x - from.x)) * Mathf.Rad2Deg, 2f);
        Assert.Contains(ImmediateGui.Lines, line => (line.From - from).magnitude < 0.01f && (line.To - to).magnitude < 0.01f);

        ImmediateGui.Click(inspector.OnInspectorGUI, GenericRigDriverEditor.PreviewLabel);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Empty(ImmediateGui.Lines);
    }

    private static GenericRigDriver AddDriver(out Dictionary<Bone, Transform> bones) => GenericRig.BuildInAPose(out bones).AddComponent<GenericRigDriver>();
}
