using NeuronMocap.Skeleton;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

// The changes of the rig check to a model's import settings.
public sealed class ModelImportTests : IDisposable
{
    private const string File = "Assets/Model.fbx";

    private readonly EditorWorld _world = new();
    private readonly HumanoidFigure _figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
    private readonly ModelImporter _importer = AssetImporter.Add(File, new ModelImporter());

    public void Dispose() => _world.Dispose();

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void The_imported_rest_pose_becomes_a_T_pose(bool isConfigured)
    {
        HumanDescription hanging = Hang(_figure.Avatar.humanDescription, _figure.GetBone(Bone.LeftArm).name, 60);
        UseAvatar(hanging);
        _importer.humanDescription = isConfigured ? hanging : new HumanDescription { upperArmTwist = 0.7f };
        _importer.Imported = () => UseAvatar(_importer.humanDescription);
        HumanoidDriver driver = AddDriver();
        Assert.Contains(HumanoidCheck.Examine(driver), static problem => problem.FixLabel == RigIssues.FixLabel);

        ImmediateGui.Click(_world.Inspect(driver).OnInspectorGUI, RigIssues.FixLabel);

        Assert.Equal(1, _importer.Imports);
        Assert.DoesNotContain(HumanoidCheck.Examine(driver), static problem => problem.Severity >= Severity.Warning);
        Assert.Equal(isConfigured ? hanging.upperArmTwist : 0.7f, _importer.humanDescription.upperArmTwist);
        Assert.Equal(hanging.human.Select(static bone => bone.boneName), _importer.humanDescription.human.Select(static bone => bone.boneName));
        Assert.Equal(hanging.skeleton.Select(static bone => bone.name), _importer.humanDescription.skeleton.Select(static bone => bone.name));
        SkeletonBone arm = _importer.humanDescription.skeleton.Single(bone => bone.name == _figure.GetBone(Bone.LeftArm).name);
        Assert.True(Quaternion.Angle(arm.rotation, _figure.GetBone(Bone.LeftArm).localRotation) < 12);

        // The original description belongs to another object.
        Assert.Equal(60, Quaternion.Angle(hanging.skeleton.Single(bone => bone.name == arm.name).rotation, Quaternion.identity), 0.1f);
    }

    [Fact]
    public void The_model_s_avatar_is_assigned_with_a_click()
    {
        Avatar avatar = _figure.Avatar;
        AssetDatabase.Add(File, _figure.Renderer.sharedMesh!, avatar);
        _figure.Animator.avatar = null;
        HumanoidDriver driver = AddDriver();

        ImmediateGui.Click(_world.Inspect(driver).OnInspectorGUI, $"Assign {avatar.name}");
        Assert.Same(avatar, _figure.Animator.avatar);
        Assert.Equal(0, _importer.Imports);

        Undo.PerformUndo();
        Assert.True(_figure.Animator.avatar == null);
    }

    [Fact]
    public void A_model_without_an_avatar_is_imported_as_Humanoid_and_its_avatar_assigned()
    {
        Avatar avatar = _figure.Avatar;
        AssetDatabase.Add(File, _figure.Renderer.sharedMesh!);
        _importer.Imported = () => AssetDatabase.Add(File, _figure.Renderer.sharedMesh!, avatar);
        _figure.Animator.avatar = null;
        HumanoidDriver driver = AddDriver();

        ImmediateGui.Click(_world.Inspect(driver).OnInspectorGUI, "Import the Model as Humanoid");

        Assert.Equal((ModelImporterAnimationType.Human, ModelImporterAvatarSetup.CreateFromThisModel), (_importer.animationType, _importer.avatarSetup));
        Assert.Same(avatar, _figure.Animator.avatar);
        Assert.DoesNotContain(HumanoidCheck.Examine(driver), static problem => problem.Severity == Severity.Error);
    }

    [Fact]
    public void Optimized_bones_become_transforms_again_with_a_click()
    {
        Transform[] parts = [.. _figure.Root.transform.Cast<Transform>()];
        foreach (Transform part in parts)
            part.SetParent(null, false);

        AssetDatabase.Add(File, _figure.Avatar);
        _figure.Animator.avatar = _figure.Avatar;
        (_importer.optimizeGameObjects, _importer.animationType) = (true, ModelImporterAnimationType.Human);
        _importer.Imported = () =>
        {
            foreach (Transform part in parts)
                part.SetParent(_figure.Root.transform, false);

            _figure.Animator.avatar = _figure.Avatar;
        };
        HumanoidDriver driver = AddDriver();
        Assert.Contains("Optimize Game Objects", Assert.Single(HumanoidCheck.Examine(driver)).Text, StringComparison.Ordinal);

        ImmediateGui.Click(_world.Inspect(driver).OnInspectorGUI, "Switch Optimizing Off");

        Assert.Equal((false, 1), (_importer.optimizeGameObjects, _importer.Imports));
        Assert.DoesNotContain(HumanoidCheck.Examine(driver), static problem => problem.Severity >= Severity.Warning);
    }

    [Fact]
    public void Optimized_bones_without_a_model_are_only_reported()
    {
        foreach (Transform part in _figure.Root.transform.Cast<Transform>().ToArray())
            Object.DestroyImmediate(part.gameObject);

        _figure.Animator.avatar = _figure.Avatar;

        RigProblem problem = Assert.Single(HumanoidCheck.Examine(AddDriver()));
        Assert.Contains("Optimize Game Objects", problem.Text, StringComparison.Ordinal);
        Assert.Null(problem.FixLabel);
    }

    // Unity reports an avatar that it could not create as not human. Another import as Humanoid would change nothing.
    [Fact]
    public void Missing_bones_of_an_avatar_are_named()
    {
        HumanDescription lacking = _figure.Avatar.humanDescription;
        lacking.human = [.. lacking.human.Where(static bone => bone.humanName is not ("LeftHand" or "RightFoot" or "LeftToes"))];
        Avatar broken = AvatarBuilder.BuildHumanAvatar(_figure.Root, lacking);
        Assert.Equal((false, false), (broken.isValid, broken.isHuman));
        ConsoleLog.Clear();
        AssetDatabase.Add(File, broken);
        _figure.Animator.avatar = broken;

        RigProblem problem = Assert.Single(HumanoidCheck.Examine(AddDriver()));

        Assert.Equal(Severity.Error, problem.Severity);
        Assert.Contains("it does not map RightFoot, LeftHand. In the model's import settings", problem.Text, StringComparison.Ordinal);
        Assert.Null(problem.FixLabel);
    }

    [Fact]
    public void A_refused_avatar_with_all_bones_is_reported()
    {
        HumanDescription hanging = Hang(_figure.Avatar.humanDescription, _figure.GetBone(Bone.LeftArm).name, 60);
        _figure.Animator.avatar = new Avatar(isValid: false, isHuman: false, hanging);

        Assert.Contains("Unity did not accept its bones", Assert.Single(HumanoidCheck.Examine(AddDriver())).Text, StringComparison.Ordinal);
    }

    private HumanoidDriver AddDriver() => _figure.Root.AddComponent<HumanoidDriver>();

    private void UseAvatar(HumanDescription description)
    {
        var avatar = new Avatar(isValid: true, isHuman: true, description);
        AssetDatabase.Add(File, avatar);
        _figure.Animator.avatar = avatar;
    }

    private static HumanDescription Hang(HumanDescription description, string bone, float degrees)
    {
        description.skeleton = [.. description.skeleton];
        int index = Array.FindIndex(description.skeleton, found => found.name == bone);
        description.skeleton[index].rotation = Quaternion.Euler(0, 0, degrees);
        return description;
    }
}
