using System.Diagnostics;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.LiveCapture;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEditor;
using LiveRecorder = Unity.LiveCapture.TakeRecorder;

namespace NeuronMocap.Unity.Tests.Editor;

// The capture device for Unity's Take Recorder.
public sealed class LiveCaptureTests
{
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_humanoid_is_recorded_in_play_mode_and_in_a_preview(bool plays)
    {
        using var world = new EditorWorld(plays);
        MocapSource source = Stage.AddSimulator();
        HumanoidDriver driver = TestFigure.Build("Hero").Drive(source);
        FigureCaptureDevice device = AddDevice(driver);
        if (!plays)
            LivePreview.Start(source);

        Record(world, () => driver.IsDriving);

        (string name, Animator animator, AnimationClip clip) = Assert.Single(LiveRecorder.Tracks);
        Assert.Equal("Hero", name);
        Assert.Same(driver.GetComponentInChildren<Animator>(), animator);
        Assert.True(clip.isHumanMotion);
        Assert.Equal(30, clip.frameRate);
        AnimationCurve curve = AnimationUtility.GetEditorCurve(clip, EditorCurveBinding.FloatCurve("", typeof(Animator), "RootT.x"))!;
        Assert.Equal(0, curve.keys[0].time);
        Assert.True(curve.length >= 5, $"{curve.length} keys");
        Assert.Empty(device.Problem);
        LivePreview.StopAll();
    }

    [Fact]
    public void Another_figure_is_recorded_with_its_own_transforms()
    {
        using var world = new EditorWorld(play: true);
        GenericRigDriver driver = GenericRig.BuildInAPose(out Dictionary<Bone, Transform> bones).AddComponent<GenericRigDriver>();
        driver.Source = Stage.AddSimulator();
        driver.gameObject.AddComponent<Animator>();
        AddDevice(driver);

        Record(world, () => driver.IsDriving);

        AnimationClip clip = Assert.Single(LiveRecorder.Tracks).Clip;
        Assert.False(clip.isHumanMotion);
        Assert.Contains(AnimationUtility.GetCurveBindings(clip), binding => binding.path.EndsWith(bones[Bone.LeftForeArm].name, StringComparison.Ordinal) && binding.type == typeof(Transform));
    }

    [Fact]
    public void A_figure_whose_first_child_is_a_mesh_is_recorded_with_its_bones()
    {
        using var world = new EditorWorld(play: true);
        GenericRigDriver driver = GenericRig.BuildAfterMesh(out _).AddComponent<GenericRigDriver>();
        driver.Source = Stage.AddSimulator();
        driver.gameObject.AddComponent<Animator>();
        AddDevice(driver);

        Record(world, () => driver.IsDriving);

        AnimationClip clip = Assert.Single(LiveRecorder.Tracks).Clip;
        Assert.Contains(AnimationUtility.GetCurveBindings(clip), static binding => binding is { path: "Hips", propertyName: "m_LocalPosition.y" });
    }

    [Fact]
    public void What_is_missing_is_named_and_no_track_is_added()
    {
        using var world = new EditorWorld();
        FigureCaptureDevice device = AddDevice(null);
        Assert.False(device.IsReady());
        Assert.Contains("Set Figure", device.Problem, StringComparison.Ordinal);

        device.Figure = GenericRig.BuildInAPose(out _).AddComponent<GenericRigDriver>();
        Assert.False(device.IsReady());
        Assert.Contains("no Animator", device.Problem, StringComparison.Ordinal);

        device.Figure.gameObject.AddComponent<Animator>();
        Assert.False(device.IsReady());
        Assert.Contains("Preview", device.Problem, StringComparison.Ordinal);

        LiveRecorder.StartRecording();
        LiveRecorder.StopRecording();
        Assert.Empty(LiveRecorder.Tracks);
    }

    [Fact]
    public void A_figure_that_is_deleted_during_a_take_ends_its_part_quietly()
    {
        using var world = new EditorWorld(play: true);
        HumanoidDriver driver = TestFigure.Build("Hero").Drive(Stage.AddSimulator());
        FigureCaptureDevice device = AddDevice(driver);
        world.Loop.RunUntil(() => driver.IsDriving);
        LiveRecorder.StartRecording();
        world.Loop.Frames(3);

        Object.DestroyImmediate(driver.gameObject);
        world.Loop.RunFor(0.1f);
        LiveRecorder.StopRecording();

        Assert.Empty(LiveRecorder.Tracks);
        Assert.False(device.IsReady());
        Assert.Empty(ConsoleLog.Problems);
    }

    [Fact]
    public void A_take_belongs_to_the_figure_it_began_with()
    {
        using var world = new EditorWorld(play: true);
        MocapSource source = Stage.AddSimulator();
        HumanoidDriver driver = TestFigure.Build("Hero").Drive(source);
        FigureCaptureDevice device = AddDevice(driver);
        world.Loop.RunUntil(() => driver.IsDriving);
        LiveRecorder.StartRecording();
        world.Loop.RunFor(0.1f);

        device.Figure = TestFigure.Build("Other").Drive(source);
        LiveRecorder.StopRecording();

        Assert.Equal("Hero", Assert.Single(LiveRecorder.Tracks).Name);
    }

    [Fact]
    public void A_take_that_ends_at_once_has_no_track()
    {
        using var world = new EditorWorld(play: true);
        HumanoidDriver driver = TestFigure.Build("Hero").Drive(Stage.AddSimulator());
        AddDevice(driver);
        world.Loop.RunUntil(() => driver.IsDriving);

        LiveRecorder.StartRecording();
        LiveRecorder.StopRecording();

        Assert.Empty(LiveRecorder.Tracks);
    }

    private static FigureCaptureDevice AddDevice(FigureDriver? figure)
    {
        FigureCaptureDevice device = new GameObject("Device").AddComponent<FigureCaptureDevice>();
        (device.Figure, device.KeyTolerance) = (figure, 0);
        return device;
    }

    private static void Record(EditorWorld world, Func<bool> isReady)
    {
        world.Loop.RunUntil(() => Tick() && isReady());
        LiveRecorder.StartRecording();
        world.Loop.RunUntil(() => Tick() && LiveRecorder.IsRecording());

        // The device takes a frame of each thirtieth of a second, however long the frames of the game are.
        for (int i = 0; i < 8; i++)
        {
            var time = Stopwatch.StartNew();
            world.Loop.RunUntil(() => time.Elapsed.TotalSeconds > 0.04);
        }

        LiveRecorder.StopRecording();

        static bool Tick()
        {
            EditorApplication.Tick(0.01);
            return true;
        }
    }
}
