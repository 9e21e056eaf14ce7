using System.Diagnostics;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;
using NeuronMocap.Unity.Timeline;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine.Playables;
using UnityEngine.SceneManagement;
using UnityEngine.Timeline;

namespace NeuronMocap.Unity.Tests.Editor;

// The preview of a source in edit mode.
public sealed class LivePreviewTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("scenes").FullName;
    private readonly EditorWorld _world = new();
    private readonly MocapSource _source;
    private readonly HumanoidDriver _driver;
    private readonly TestFigure _figure;
    private readonly (Transform Node, Vector3 Position, Quaternion Rotation)[] _scene;

    public LivePreviewTests()
    {
        _source = Stage.AddSimulator();
        _figure = TestFigure.Build("Figure");
        _driver = _figure.Drive(null);
        _driver.transform.SetPositionAndRotation(new Vector3(1, 0, 2), Quaternion.Euler(0, 30, 0));
        _figure[Bone.LeftArm].localRotation = Quaternion.Euler(0, 0, 40);
        _scene = Array.ConvertAll(_driver.GetComponentsInChildren<Transform>(), static node => (node, node.localPosition, node.localRotation));
    }

    public void Dispose()
    {
        _world.Dispose();
        Assert.Equal(0, SourceConnections.Count);
        Assert.True(SourceConnections.Closed.Wait(Limits.Unexpected));
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void The_button_of_the_inspector_moves_the_figure_and_brings_it_back()
    {
        Action inspector = _world.Inspect(_source).OnInspectorGUI;
        ImmediateGui.Click(inspector, PreviewButton.Label);
        TickUntil(() => _driver.IsDriving);
        Assert.False(IsAsInScene());
        Assert.False(Application.isPlaying);
        ImmediateGui.Draw(inspector);
        Assert.Equal("on", Toggle().Value);
        Assert.Equal(ReportGui.ColorOf(Severity.Good, isDarkSkin: true), EditorWorld.DotOf("Receiving"));

        ImmediateGui.Draw(_world.Inspect(_driver).OnInspectorGUI);
        Assert.Equal(ReportGui.ColorOf(Severity.Good, isDarkSkin: true), EditorWorld.DotOf($"Follows {_driver.Performer}"));
        Assert.DoesNotContain(FigureDriverEditor.CheckAgain, EditorWorld.Labels("Button"));

        ImmediateGui.Click(inspector, PreviewButton.Label);
        AssertEnded();
        ImmediateGui.Draw(_world.Inspect(_driver).OnInspectorGUI);
        Assert.Contains(FigureDriverEditor.CheckAgain, EditorWorld.Labels("Button"));
    }

    [Fact]
    public void The_window_has_the_button_and_closing_the_window_ends_the_preview()
    {
        SourcesWindow window = SourcesWindow.Open();
        ImmediateGui.Click((Action)Delegate.CreateDelegate(typeof(Action), window, "OnGUI"), PreviewButton.Label);
        TickUntil(() => _driver.IsDriving);
        Assert.NotNull(window.Shown);

        window.Close();
        AssertEnded();
    }

    public static TheoryData<string> Ends => ["reload", "play", "save", "save prefab", "open scene", "disable", "remove", "quit"];

    [Theory]
    [MemberData(nameof(Ends))]
    public void The_preview_ends_before_its_pose_can_be_kept(string end)
    {
        Begin();
        bool wasRestored = false;
        EditorSceneManager.sceneSaving += (_, _) => wasRestored = IsAsInScene();
        switch (end)
        {
            case "reload":
                AssemblyReloadEvents.beforeAssemblyReload += () => wasRestored = IsAsInScene();
                _world.Loop.ReloadDomain();
                Assert.True(wasRestored);
                break;
            case "play":
                EditorApplication.playModeStateChanged += change => wasRestored |= change == PlayModeStateChange.ExitingEditMode && IsAsInScene();
                _world.Loop.EnterPlayMode();
                Assert.True(wasRestored);
                Assert.False(LivePreview.IsOn);
                _world.Loop.ExitPlayMode();
                return;
            case "save":
                Save();
                Assert.True(wasRestored);
                break;
            case "save prefab":
                PrefabStage.RaiseSaving(_driver.gameObject);
                break;
            case "open scene":
                EditorSceneManager.sceneClosing += (_, _) => wasRestored |= IsAsInScene();
                EditorSceneManager.OpenScene(Save(), OpenSceneMode.Single);
                Assert.True(wasRestored);
                Assert.False(LivePreview.IsOn);
                return;
            case "disable":
                _source.enabled = false;
                EditorApplication.Tick(0.01);
                break;
            case "remove":
                Object.DestroyImmediate(_source);
                EditorApplication.Tick(0.01);
                break;
            default:
                EditorApplication.RaiseQuitting();
                break;
        }

        AssertEnded();
    }

    [Fact]
    public void The_scene_stays_unchanged_and_clean()
    {
        _driver.RootMotionTarget = RootMotionTarget.RootTransform;
        Begin();
        TickUntil(() => (_driver.transform.position - new Vector3(1, 0, 2)).magnitude > 0.01f);
        int components = World.Objects.Count;

        LivePreview.Stop(_source);

        AssertEnded();
        Assert.False(SceneManager.GetActiveScene().isDirty);
        Assert.Empty(Undo.Names);
        Assert.Equal(components, World.Objects.Count);
    }

    // Root motion moves the hips here, so the place of the figure is the user's.
    [Fact]
    public void A_figure_that_is_placed_elsewhere_during_a_preview_stays_there()
    {
        Transform above = new GameObject("Stage").transform;
        _driver.transform.SetParent(above, worldPositionStays: false);
        Begin();
        above.position = new Vector3(0, 0, 7);
        (_driver.transform.localPosition, _driver.transform.localRotation) = (new Vector3(4, 0, -1), Quaternion.Euler(0, 90, 0));
        EditorApplication.Tick(0.01);

        LivePreview.StopAll();

        Assert.Equal(new Vector3(0, 0, 7), above.position);
        Assert.Equal(new Vector3(4, 0, -1), _driver.transform.localPosition);
        (_driver.transform.localPosition, _driver.transform.localRotation) = (_scene[0].Position, _scene[0].Rotation);
        Assert.True(IsAsInScene());
    }

    [Fact]
    public void A_character_controller_moves_without_physics()
    {
        CharacterController controller = _driver.gameObject.AddComponent<CharacterController>();
        _driver.RootMotionTarget = RootMotionTarget.CharacterController;
        Begin();
        TickUntil(() => (_driver.transform.position - new Vector3(1, 0, 2)).magnitude > 0.01f);
        Assert.Equal(0, controller.transform.position.y, 0.1f);

        LivePreview.StopAll();
        AssertEnded();
    }

    [Fact]
    public void A_figure_with_bodies_moves_without_physics_and_returns()
    {
        FigureColliders.Add(_driver);
        _driver.DriveTime = DriveTime.Physics;
        Begin();
        TickUntil(() => Quaternion.Angle(_figure[Bone.LeftArm].rotation, _scene[0].Rotation) > 5);
        Assert.Empty(_driver.Problem);

        LivePreview.StopAll();
        AssertEnded();
    }

    [Fact]
    public void A_figure_that_leaves_its_source_or_is_disabled_returns_to_its_pose()
    {
        Begin();
        _driver.enabled = false;
        EditorApplication.Tick(0.01);
        Assert.True(IsAsInScene());

        _driver.enabled = true;
        TickUntil(() => _driver.IsDriving);
        _driver.Source = Stage.AddSimulator();
        EditorApplication.Tick(0.01);
        Assert.True(IsAsInScene());

        _driver.Source = _source;
        TickUntil(() => _driver.IsDriving);
        Object.DestroyImmediate(_driver);
        EditorApplication.Tick(0.01);
        Assert.True(IsAsInScene());
        LivePreview.StopAll();
    }

    [Fact]
    public void Timeline_may_take_the_figure_during_a_preview()
    {
        PlayableDirector director = new GameObject("Director").AddComponent<PlayableDirector>();
        TimelineAsset timeline = ScriptableObject.CreateInstance<TimelineAsset>();
        MotionTrack track = timeline.CreateTrack<MotionTrack>(null, "Motion");
        director.playableAsset = timeline;
        director.SetGenericBinding(track, _driver);
        TimelineClip clip = track.CreateClip<MotionClip>();
        ((MotionClip)clip.asset).File = Path.Combine(Repository.Root, "samples", "takes", "walk.bvh");
        clip.duration = 1;
        Begin();

        director.Evaluate();
        EditorApplication.Tick(0.01);
        Assert.True(_driver.IsPosed);
        Assert.False(_driver.IsDriving);
        ImmediateGui.Draw(_world.Inspect(_driver).OnInspectorGUI);
        Assert.DoesNotContain(FigureDriverEditor.CheckAgain, EditorWorld.Labels("Button"));
        director.Stop();
        TickUntil(() => _driver.IsDriving);

        director.Evaluate();
        LivePreview.Stop(_source);
        director.Stop();
        AssertEnded();
    }

    // Without play mode, the time of the game need not pass.
    [Fact]
    public void A_figure_rests_when_its_file_has_ended()
    {
        (_source.Kind, _source.File) = (SourceKind.BvhFile, Path.Combine(Repository.Root, "samples", "takes", "walk.bvh"));
        (_source.Loop, _source.Speed, _source.IdleTimeout) = (false, 10, 0.1f);
        _driver.WhenIdle = IdleBehaviour.BlendToRest;
        Begin();

        TickUntil(() => _driver.Performer is { IsLive: false } && Quaternion.Angle(_figure.Turn(Bone.LeftArm), Quaternion.identity) < 0.5f);

        LivePreview.StopAll();
    }

    [Fact]
    public void A_figure_bound_again_keeps_the_rest_pose_of_the_scene()
    {
        GenericRigDriver rig = GenericRig.BuildInAPose(out Dictionary<Bone, Transform> bones).AddComponent<GenericRigDriver>();
        (rig.Source, rig.RestPoseChoice) = (_source, RestPoseChoice.AsItStands);
        Quaternion scene = bones[Bone.LeftArm].localRotation;
        LivePreview.Start(_source);
        TickUntil(() => rig.IsDriving && Quaternion.Angle(bones[Bone.LeftArm].localRotation, scene) > 5);
        System.Numerics.Quaternion rest = RestOf();

        rig.Rebind();
        TickUntil(() => rig.IsDriving);
        Assert.Equal(rest, RestOf());

        LivePreview.StopAll();
        Assert.True(Distance(bones[Bone.LeftArm].localRotation, scene) < 1e-6f);

        System.Numerics.Quaternion RestOf() => rig.TargetRig!.Nodes[rig.TargetRig.GetNode(Bone.LeftArm)].Rotation;
    }

    [Fact]
    public void A_file_plays_although_the_game_does_not()
    {
        (_source.Kind, _source.File) = (SourceKind.BvhFile, Path.Combine(Repository.Root, "samples", "takes", "walk.bvh"));
        Begin();
        Vector3 first = _source.Performers[0].GetPosition(Bone.Hips);

        TickUntil(() => (_source.Performers[0].GetPosition(Bone.Hips) - first).magnitude > 0.05f);

        LivePreview.StopAll();
    }

    [Fact]
    public void A_file_that_is_missing_is_explained()
    {
        (_source.Kind, _source.File) = (SourceKind.BvhFile, "missing.bvh");
        LivePreview.Start(_source);
        TickUntil(() => _source.State == SourceState.Failed);

        ImmediateGui.Draw(_world.Inspect(_source).OnInspectorGUI);
        Assert.Contains(EditorWorld.Controls, static control => control.Kind == "HelpBox" && control.Value == "Error" && control.Label.Contains("missing.bvh", StringComparison.Ordinal));
        LivePreview.StopAll();
    }

    [Fact]
    public void Two_previews_are_independent()
    {
        MocapSource other = Stage.AddSimulator();
        LivePreview.Start(other);
        Begin();

        LivePreview.Stop(other);
        Assert.True(LivePreview.Includes(_source));
        TickUntil(() => _driver.IsDriving && _driver.ActiveSource == _source);
        LivePreview.Stop(_source);
        AssertEnded();
    }

    [Fact]
    public void A_setting_applies_at_once()
    {
        Begin();
        _source.PerformerCount = 2;

        TickUntil(() => _source.Performers.Count == 2);

        LivePreview.StopAll();
    }

    [Fact]
    public void There_is_no_preview_of_what_cannot_run()
    {
        _source.enabled = false;
        ImmediateGui.Draw(_world.Inspect(_source).OnInspectorGUI);
        Assert.False(Toggle().IsEnabled);
        LivePreview.Start(_source);
        Assert.False(LivePreview.IsOn);

        using var playing = new EditorWorld(play: true);
        ImmediateGui.Draw(playing.Inspect(Stage.AddSimulator()).OnInspectorGUI);
        Assert.DoesNotContain(PreviewButton.Label, EditorWorld.Labels("Toggle"));
    }

    // The time of the editor is that of the simulator, which has threads of its own. A faster one would let the performer seem lost on a busy computer.
    private void TickUntil(Func<bool> condition)
    {
        MainThread.Claim();
        long last = Stopwatch.GetTimestamp();
        bool isTrue = SpinWait.SpinUntil(
            () =>
            {
                long now = Stopwatch.GetTimestamp();
                EditorApplication.Tick((now - last) / (double)Stopwatch.Frequency);
                last = now;
                return condition();
            },
            Limits.Unexpected);
        Assert.True(isTrue, $"{MocapSource.All.Count} sources, {_source.State}: {_source.StatusMessage} {_driver.Performer} {_driver.Problem}");
    }

    private static GuiControl Toggle() => EditorWorld.Controls.Single(static control => control.Kind == "Toggle" && control.Label == PreviewButton.Label);

    private string Save()
    {
        Scene scene = SceneManager.GetActiveScene();
        string path = Path.Combine(_folder, $"{Guid.NewGuid():N}.unity");
        SceneManager.Paths[scene.name] = path;
        EditorSceneManager.SaveScene(scene);
        return path;
    }

    private void Begin()
    {
        LivePreview.Start(_source);
        TickUntil(() => _driver.IsDriving && !IsAsInScene());
    }

    // Unity normalises a rotation when it is set.
    private bool IsAsInScene() => _scene.All(static place => place.Node.localPosition.Equals(place.Position) && Distance(place.Node.localRotation, place.Rotation) < 1e-6f);

    private static float Distance(Quaternion first, Quaternion second) =>
        Mathf.Abs(first.x - second.x) + Mathf.Abs(first.y - second.y) + Mathf.Abs(first.z - second.z) + Mathf.Abs(first.w - second.w);

    private void AssertEnded()
    {
        Assert.False(LivePreview.IsOn);
        Assert.True(IsAsInScene());
        Assert.False(_driver.IsPreviewed);
        Assert.Equal(string.Empty, _driver.Problem);
        Assert.Empty(MocapSource.All);
        Assert.Equal(0, SourceConnections.Count);
        EditorApplication.Tick(0.01);
        Assert.True(IsAsInScene());
    }
}
