using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

/// <summary>Takes of the Sources window: name, slate, and what is written.</summary>
public sealed class SourceTakeTests : IDisposable
{
    private readonly EditorWorld _world = new(play: true);
    private readonly string _folderBefore = Application.Folder;
    private readonly string _folder = Directory.CreateTempSubdirectory("project").FullName;
    private readonly SourcesWindow _window;
    private readonly Action _draw;

    public SourceTakeTests()
    {
        ClipSaver.Register();
        Application.Folder = _folder;
        Forget();
        _window = SourcesWindow.Open();
        _draw = (Action)Delegate.CreateDelegate(typeof(Action), _window, "OnGUI");
    }

    private string Recordings => Path.Combine(_folder, "Recordings");

    public void Dispose()
    {
        MainThread.Claim();
        _window.Close();
        _world.Dispose();
        Forget();
        Application.Folder = _folderBefore;
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void A_source_is_recorded_beside_Assets_with_two_clicks()
    {
        MocapSource source = AddSimulator();
        Record(source);

        string file = Assert.Single(Directory.GetFiles(Recordings, "*.nmrec"));
        Assert.Equal("Take 001.nmrec", Path.GetFileName(file));
        Assert.Contains("Recorded Take 001: ", EditorWorld.Find("Recorded ").Label, StringComparison.Ordinal);
        using RecordingReader recording = RecordingReader.Open(file);
        Assert.True(recording.IsComplete);
        Assert.Empty(recording.Problems);
    }

    [Fact]
    public void The_slate_counts_up_and_is_kept()
    {
        MocapSource source = AddSimulator();
        ImmediateGui.Set(_draw, "Take Name", "Shot");
        ImmediateGui.Set(_draw, "Slate", 7);
        ImmediateGui.Set(_draw, "Formats", TakeFormats.Bvh);
        Record(source);
        Record(source);

        string[] files = [.. Directory.GetFiles(Recordings).Select(static path => Path.GetFileName(path)!).Order(StringComparer.Ordinal)];
        Assert.Equal(2, files.Length);
        Assert.StartsWith("Shot 007", files[0], StringComparison.Ordinal);
        Assert.StartsWith("Shot 008", files[1], StringComparison.Ordinal);
        Assert.All(files, file => Assert.True(BvhDocument.Load(Path.Combine(Recordings, file)).FrameCount > 10));
        Assert.Equal("Shot 009", EditorWorld.Find("Next take").Value);

        TakeSettings.Forget();
        Assert.Equal("Shot 009", TakeSettings.instance.NextName);
    }

    [Fact]
    public void The_fields_of_a_take_can_be_edited_also_after_a_restart()
    {
        AddSimulator();
        ImmediateGui.Set(_draw, "Take Name", "Shot");
        TakeSettings.Forget();
        ImmediateGui.Set(_draw, "Slate", 7);

        Assert.Equal("Shot 007", TakeSettings.instance.NextName);
        ImmediateGui.Draw(_draw);
        Assert.All(EditorWorld.Controls.Where(static control => control.Kind == "Property"), static field => Assert.True(field.IsEnabled, field.Label));
    }

    [Theory]
    [InlineData(ClipKind.Humanoid, "LeftFootT.y")]
    [InlineData(ClipKind.Generic, "m_LocalPosition.y")]
    public void The_characters_of_a_source_become_clips(ClipKind kind, string property)
    {
        MocapSource source = AddSimulator();
        var holder = new GameObject("Ann");
        HumanoidDriver driver = holder.AddComponent<HumanoidDriver>();
        driver.Source = source;
        holder.AddComponent<FigureBuilder>();
        _world.Loop.RunUntil(() => driver.IsDriving);
        ImmediateGui.Set(_draw, "Take Name", $"{kind} shot");
        ImmediateGui.Set(_draw, "Clips", true);
        ImmediateGui.Set(_draw, "Clip Kind", kind);
        Record(source);

        Assert.Contains("1 clip", EditorWorld.Find("Recorded ").Label, StringComparison.Ordinal);
        AnimationClip? clip = AssetDatabase.LoadAssetAtPath<AnimationClip>($"Assets/Recordings/{kind} shot 001 Ann.anim");
        Assert.NotNull(clip);
        Assert.Contains(AnimationUtility.GetCurveBindings(clip), binding => binding.propertyName == property);
        Assert.Null(holder.GetComponent<ClipRecorder>());
    }

    [Fact]
    public void A_character_whose_first_child_is_a_mesh_becomes_a_clip_of_its_bones()
    {
        MocapSource source = AddSimulator();
        GenericRigDriver driver = GenericRig.BuildAfterMesh(out _).AddComponent<GenericRigDriver>();
        driver.Source = source;
        _world.Loop.RunUntil(() => driver.IsDriving);
        TakeSettings settings = TakeSettings.instance;
        (settings.TakeName, settings.Clips, settings.Formats) = ("Mesh", true, TakeFormats.None);
        using var take = new SourceTake(source, settings, Recordings);
        _world.Loop.Frames(3);
        take.Stop();

        Assert.Empty(take.Problem);
        AnimationClip clip = AssetDatabase.LoadAssetAtPath<AnimationClip>(Assert.Single(take.Clips))!;
        Assert.Contains(AnimationUtility.GetCurveBindings(clip), static binding => binding is { path: "Hips", propertyName: "m_LocalPosition.y" });
    }

    [Fact]
    public void The_clip_of_a_character_that_is_deleted_during_the_take_is_listed()
    {
        MocapSource source = AddSimulator();
        var holder = new GameObject("Ann");
        HumanoidDriver driver = holder.AddComponent<HumanoidDriver>();
        driver.Source = source;
        holder.AddComponent<FigureBuilder>();
        _world.Loop.RunUntil(() => driver.IsDriving);
        TakeSettings settings = TakeSettings.instance;
        (settings.TakeName, settings.Clips, settings.Formats) = ("Gone", true, TakeFormats.None);
        using var take = new SourceTake(source, settings, Recordings);
        _world.Loop.Frames(3);

        Object.DestroyImmediate(holder);
        _world.Loop.Frames(2);
        take.Update();

        Assert.False(take.IsRunning);
        Assert.Equal("Assets/Recordings/Gone 001 Ann.anim", Assert.Single(take.Clips));
        Assert.Empty(take.Problem);
    }

    [Fact]
    public void A_take_ends_with_its_source()
    {
        MocapSource source = AddSimulator();
        ImmediateGui.Click(_draw, SourcePanel.Record);
        _world.Loop.RunUntil(() => Says("Recording Take 001: ") && File.Exists(Path.Combine(Recordings, "Take 001.nmrec")));
        source.enabled = false;
        _world.Loop.RunUntil(() => Says("Recorded Take 001: "));
    }

    [Fact]
    public void A_failed_folder_is_reported()
    {
        AddSimulator();
        File.WriteAllText(Recordings, "");

        ImmediateGui.Click(_draw, SourcePanel.Record);
        _world.Loop.RunUntil(() => Says("The take cannot start"));

        Assert.Equal("Error", EditorWorld.Find("The take cannot start").Value);
        _world.Loop.RunUntil(() =>
        {
            ImmediateGui.Draw(_draw);
            return EditorWorld.Labels("Button").Contains(SourcePanel.Record);
        });
    }

    [Fact]
    public void Without_a_format_there_is_nothing_to_record()
    {
        AddSimulator();
        ImmediateGui.Set(_draw, "Formats", TakeFormats.None);
        ImmediateGui.Draw(_draw);
        Assert.False(EditorWorld.Find(SourcePanel.Record).IsEnabled);

        ImmediateGui.Set(_draw, "Clips", true);
        ImmediateGui.Click(_draw, SourcePanel.Record);
        ImmediateGui.Draw(_draw);
        Assert.Contains("the source moves no character", EditorWorld.Find("nothing to record").Label, StringComparison.Ordinal);
        Assert.Contains(SourcePanel.Record, EditorWorld.Labels("Button"));
    }

    [Fact]
    public void In_a_preview_clips_need_play_mode()
    {
        _world.Loop.ExitPlayMode();
        MocapSource source = _world.AddSource(static source => source.Kind = SourceKind.Simulator);
        LivePreview.Start(source);
        Assert.True(LivePreview.IsOn);
        TakeSettings settings = TakeSettings.instance;
        (settings.Clips, settings.Formats) = (true, TakeFormats.None);
        int components = World.Objects.Count;

        using var take = new SourceTake(source, settings, Recordings);

        Assert.Contains("play mode", take.Problem, StringComparison.Ordinal);
        Assert.False(take.IsRunning);
        Assert.Equal(components, World.Objects.Count);
        LivePreview.StopAll();
    }

    [Fact]
    public void A_take_ends_with_the_preview_and_its_file_is_complete()
    {
        _world.Loop.ExitPlayMode();
        MocapSource source = _world.AddSource(static source => source.Kind = SourceKind.Simulator);
        LivePreview.Start(source);
        Assert.True(LivePreview.IsOn);
        SourceTake? started = null;
        TickUntil(() => Stage.IsLive(source));
        using SourceTake take = started = new SourceTake(source, TakeSettings.instance, Recordings);
        TickUntil(() => take.Files.Count == 1 && new FileInfo(take.Files[0]).Length > 1000);

        LivePreview.Stop(source);
        TickUntil(() => take.Describe().StartsWith("Recorded", StringComparison.Ordinal));

        Assert.Empty(take.Problem);
        using RecordingReader recording = RecordingReader.Open(Assert.Single(take.Files));
        Assert.True(recording.IsComplete);
        Assert.Empty(recording.Problems);

        void TickUntil(Func<bool> condition) => Assert.True(SpinWait.SpinUntil(
            () =>
            {
                EditorApplication.Tick(0.01);
                started?.Update();
                return condition();
            },
            Limits.Unexpected));
    }

    private static void Forget()
    {
        if (Directory.Exists("UserSettings"))
            File.Delete("UserSettings/NeuronMocapTakes.asset");

        TakeSettings.Forget();
    }

    private MocapSource AddSimulator()
    {
        MocapSource source = _world.AddSource(static source => source.Kind = SourceKind.Simulator, "Stage");
        EditorApplication.RaiseHierarchyChanged();
        _world.Loop.RunUntil(() => Stage.IsLive(source));
        return source;
    }

    private void Record(MocapSource source)
    {
        ImmediateGui.Click(_draw, SourcePanel.Record);
        _world.Loop.RunUntil(() => Says("Recording ") && !EditorWorld.Labels("Button").Contains(SourcePanel.Record));
        long before = source.Reader!.GetStatistics().MotionFrames;
        _world.Loop.RunUntil(() => source.Reader!.GetStatistics().MotionFrames >= before + 30);
        ImmediateGui.Click(_draw, SourcePanel.StopRecording);
        _world.Loop.RunUntil(() => Says("Recorded "));
    }

    private bool Says(string text)
    {
        ImmediateGui.Draw(_draw);
        return EditorWorld.Controls.Any(control => control.Label.Contains(text, StringComparison.Ordinal));
    }
}
