using NeuronMocap.Skeleton;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

public sealed class ClipRecorderInspectorTests : IDisposable
{
    private readonly EditorWorld _world = new(play: true);

    public ClipRecorderInspectorTests() => ClipSaver.Register();

    public void Dispose() => _world.Dispose();

    [Fact]
    public void A_clip_is_recorded_and_shown_by_buttons()
    {
        ClipRecorder recorder = AddFigure();
        UnityEditor.Editor inspector = _world.Inspect(recorder);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(ReportGui.ColorOf(Severity.None, isDarkSkin: true), EditorWorld.DotOf("Ready"));
        Assert.False(EditorWorld.Find(ClipRecorderEditor.ShowClip).IsEnabled);

        ImmediateGui.Click(inspector.OnInspectorGUI, ClipRecorderEditor.Start);
        Assert.True(recorder.IsRecording);
        _world.Loop.Frames(31);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(ReportGui.ColorOf(Severity.Good, isDarkSkin: true), EditorWorld.DotOf("Recording: 0.5 s, 31 frames"));

        ImmediateGui.Click(inspector.OnInspectorGUI, ClipRecorderEditor.Stop);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Contains(recorder.SavedPath, EditorWorld.Find("Saved as Assets/Recordings/").Label, StringComparison.Ordinal);
        Assert.Equal(2, recorder.Slate);
        ImmediateGui.Click(inspector.OnInspectorGUI, ClipRecorderEditor.ShowClip);
        Assert.Same(AssetDatabase.LoadAssetAtPath<AnimationClip>(recorder.SavedPath), EditorGUIUtility.Pinged);
        Assert.NotNull(EditorGUIUtility.Pinged);
    }

    [Fact]
    public void A_refused_start_says_why()
    {
        ClipRecorder recorder = new GameObject("Nothing").AddComponent<ClipRecorder>();
        UnityEditor.Editor inspector = _world.Inspect(recorder);

        ImmediateGui.Click(inspector.OnInspectorGUI, ClipRecorderEditor.Start);
        ImmediateGui.Draw(inspector.OnInspectorGUI);

        GuiControl advice = EditorWorld.Find("set Animator");
        Assert.Equal(("HelpBox", "Error"), (advice.Kind, advice.Value));
        Assert.False(recorder.IsRecording);
    }

    [Fact]
    public void A_start_without_a_caller_is_refused_in_the_console()
    {
        ClipRecorder recorder = new GameObject("Nothing").AddComponent<ClipRecorder>();
        recorder.RecordOnPlay = true;
        _world.Loop.Frame();

        Assert.Contains("set Animator", Assert.Single(ConsoleLog.Problems).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Clips_are_recorded_in_play_mode_only()
    {
        using var world = new EditorWorld();
        ClipRecorder recorder = AddFigure();
        Assert.False(recorder.StartRecording());
        Assert.Contains("play mode", recorder.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void The_hips_are_a_field_of_generic_clips()
    {
        ClipRecorder recorder = AddFigure();
        UnityEditor.Editor inspector = _world.Inspect(recorder);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        string[] fields = [.. EditorWorld.Labels("Property")];
        Assert.DoesNotContain("Hips", fields);
        Assert.Equal("Animator", fields[0]);
        Assert.Equal(["Take Name", "Slate", "File Name", "Record On Play"], fields[^4..]);

        recorder.Kind = ClipKind.Generic;
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Contains("Hips", EditorWorld.Labels("Property"));
    }

    private static ClipRecorder AddFigure() => HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<ClipRecorder>();
}
