using NeuronMocap.Bvh;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

public sealed class ComponentInspectorTests : IDisposable
{
    private readonly EditorWorld _world = new(play: true);

    public void Dispose() => _world.Dispose();

    [Theory]
    [InlineData(typeof(PerformerSpawner))]
    [InlineData(typeof(FigureBuilder))]
    [InlineData(typeof(MotionRecorder))]
    [InlineData(typeof(ClipRecorder))]
    [InlineData(typeof(SkeletonView))]
    public void Edit_mode_shows_fields_without_state(Type type)
    {
        using var world = new EditorWorld();
        Component component = new GameObject("Holder").AddComponent(type);

        ImmediateGui.Draw(world.Inspect(component).OnInspectorGUI);

        Assert.NotEmpty(EditorWorld.Labels("Property"));
        Assert.All(EditorWorld.Controls.Where(static control => control.Kind == "Property"), static field => Assert.NotEmpty(field.Tooltip));
        Assert.Empty(EditorWorld.Labels("Button"));
        Assert.Empty(EditorWorld.Labels("Label"));
    }

    [Fact]
    public void The_spawner_shows_its_figures_and_missing_ones()
    {
        MocapSource source = Stage.AddSimulator(performers: 2);
        PerformerSpawner spawner = new GameObject("Spawner").AddComponent<PerformerSpawner>();
        spawner.Source = source;
        spawner.MaxFigures = 1;
        UnityEditor.Editor inspector = _world.Inspect(spawner);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.Good), EditorWorld.DotOf("0 figures"));

        _world.Loop.RunUntil(() => spawner.Problem.Length > 0);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.Warning), EditorWorld.DotOf("1 figure"));
        Assert.Contains("raise Max Figures", Assert.Single(EditorWorld.Labels("HelpBox")), StringComparison.Ordinal);

        ImmediateGui.Set(inspector.OnInspectorGUI, "Max Figures", 2);
        _world.Loop.RunUntil(() => spawner.Figures.Count == 2);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.Good), EditorWorld.DotOf("2 figures"));
        Assert.Empty(EditorWorld.Labels("HelpBox"));
    }

    [Fact]
    public void A_spawner_without_a_source_names_the_field_to_set()
    {
        PerformerSpawner spawner = new GameObject("Spawner").AddComponent<PerformerSpawner>();
        UnityEditor.Editor inspector = _world.Inspect(spawner);
        _world.Loop.Frame();
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.Warning), EditorWorld.DotOf("0 figures"));
        Assert.Contains("Set Source", Assert.Single(EditorWorld.Labels("HelpBox")), StringComparison.Ordinal);

        MocapSource source = Stage.AddSimulator();
        spawner.Source = source;
        _world.Loop.RunUntil(() => spawner.Figures.Count == 1);
        Assert.Empty(spawner.Problem);

        // What else is wrong is said again after a while without a source.
        spawner.MaxFigures = 1;
        source.PerformerCount = 2;
        _world.Loop.RunUntil(() => spawner.Problem.Contains("Max Figures", StringComparison.Ordinal));
        spawner.Source = null;
        _world.Loop.Frame();
        Assert.Contains("Set Source", spawner.Problem, StringComparison.Ordinal);
        spawner.Source = source;
        _world.Loop.RunUntil(() => spawner.Problem.Contains("Max Figures", StringComparison.Ordinal));
    }

    [Fact]
    public void The_figure_builder_shows_its_sizes_and_rebuilds()
    {
        GameObject holder = new("Figure");
        HumanoidDriver driver = holder.AddComponent<HumanoidDriver>();
        FigureBuilder builder = holder.AddComponent<FigureBuilder>();
        _world.Loop.Frame();
        UnityEditor.Editor inspector = _world.Inspect(builder);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.Good), EditorWorld.DotOf("A figure with default sizes"));

        MocapSource source = Stage.AddSimulator();
        driver.Source = source;
        _world.Loop.RunUntil(() => driver.IsDriving && driver.Performer is { HasPose: true });
        HumanoidFigure before = builder.Figure!;
        ImmediateGui.Click(inspector.OnInspectorGUI, FigureBuilderEditor.Rebuild);
        Assert.NotSame(before, builder.Figure);
        Assert.False(builder.Figure!.IsDestroyed);

        holder.SetActive(false);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.False(EditorWorld.Find(FigureBuilderEditor.Rebuild).IsEnabled);
        holder.SetActive(true);
        _world.Loop.RunUntil(() => driver.IsDriving && builder.Figure is not null);

        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.Good), EditorWorld.DotOf($"A figure with the sizes of {driver.Performer!.Name}"));
    }

    [Fact]
    public void A_take_is_recorded_and_shown_by_buttons()
    {
        string folder = Directory.CreateTempSubdirectory("takes").FullName;
        try
        {
            MocapSource source = Stage.AddSimulator();
            MotionRecorder recorder = new GameObject("Recorder").AddComponent<MotionRecorder>();
            (recorder.Source, recorder.Folder) = (source, folder);
            UnityEditor.Editor inspector = _world.Inspect(recorder);
            ImmediateGui.Draw(inspector.OnInspectorGUI);
            Assert.Equal(Dot(Severity.None), EditorWorld.DotOf("Ready"));
            Assert.False(EditorWorld.Find(MotionRecorderEditor.ShowFiles).IsEnabled);

            ImmediateGui.Click(inspector.OnInspectorGUI, MotionRecorderEditor.Start);
            Assert.True(recorder.State is RecorderState.Waiting or RecorderState.Recording);
            _world.Loop.RunUntil(() => recorder.Frames >= 10);
            ImmediateGui.Draw(inspector.OnInspectorGUI);
            Assert.Equal(Dot(Severity.Good), EditorWorld.DotOf("Recording: "));

            ImmediateGui.Click(inspector.OnInspectorGUI, MotionRecorderEditor.Stop);
            _world.Loop.RunUntil(() => recorder.State == RecorderState.Idle);
            ImmediateGui.Draw(inspector.OnInspectorGUI);
            Assert.Contains("Recorded: ", EditorWorld.Find("Recorded: ").Label, StringComparison.Ordinal);

            EditorUtility.Revealed.Clear();
            ImmediateGui.Click(inspector.OnInspectorGUI, MotionRecorderEditor.ShowFiles);
            string file = Assert.Single(EditorUtility.Revealed);
            Assert.Equal(recorder.Frames, BvhDocument.Load(file).FrameCount);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    [Fact]
    public void A_recorder_without_a_source_reports_it()
    {
        MotionRecorder recorder = new GameObject("Recorder").AddComponent<MotionRecorder>();
        UnityEditor.Editor inspector = _world.Inspect(recorder);

        ImmediateGui.Click(inspector.OnInspectorGUI, MotionRecorderEditor.Start);
        ImmediateGui.Draw(inspector.OnInspectorGUI);

        GuiControl advice = EditorWorld.Find("set Source");
        Assert.Equal(("HelpBox", "Error"), (advice.Kind, advice.Value));
        Assert.Equal(Dot(Severity.Error), EditorWorld.DotOf("Ready"));
    }

    [Fact]
    public void The_skeleton_view_names_its_performer()
    {
        SkeletonView view = new GameObject("View").AddComponent<SkeletonView>();
        UnityEditor.Editor inspector = _world.Inspect(view);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.Waiting), EditorWorld.DotOf("No performer to show"));
        Assert.Contains("Set Driver, or Source", Assert.Single(EditorWorld.Labels("HelpBox")), StringComparison.Ordinal);

        MocapSource source = Stage.AddSimulator();
        view.Source = source;
        _world.Loop.RunUntil(() => view.Performer is { HasPose: true });
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(Dot(Severity.Good), EditorWorld.DotOf($"Shows {view.Performer}"));
        Assert.Empty(EditorWorld.Labels("HelpBox"));
    }

    private static Color Dot(Severity severity) => ReportGui.ColorOf(severity, isDarkSkin: true);
}
