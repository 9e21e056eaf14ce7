using NeuronMocap.Skeleton;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Recorders;

public sealed class ClipWriterTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public ClipWriterTests() => ClipSaver.Register();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void A_humanoid_clip_has_the_body_and_every_muscle_by_the_names_that_unity_reads()
    {
        MocapSource source = Stage.AddSimulator();
        ClipRecorder recorder = AddFigure(source);
        recorder.FileName = "walk {take}";
        _loop.RunUntil(() => Stage.IsLive(source));
        Assert.True(recorder.StartRecording());
        _loop.RunUntil(() => recorder.Take!.FrameCount >= 30);
        ClipTake take = recorder.Take!;
        AnimationUtility.Syncs = 0;
        EditorUtility.Progress.Clear();
        recorder.StopRecording();

        Assert.Equal(1, AnimationUtility.Syncs);
        Assert.Equal((0f, 1f), (EditorUtility.Progress[0], EditorUtility.Progress[^1]));
        Assert.Equal(EditorUtility.Progress.Order(), EditorUtility.Progress);
        Assert.False(EditorUtility.IsShowingProgress);
        Assert.Empty(recorder.Problem);
        Assert.StartsWith("Assets/Recordings/walk 001", recorder.SavedPath);
        AnimationClip clip = AssetDatabase.LoadAssetAtPath<AnimationClip>(recorder.SavedPath)!;
        EditorCurveBinding[] bindings = AnimationUtility.GetCurveBindings(clip);
        string[] body = ["RootT.x", "RootT.y", "RootT.z", "RootQ.x", "RootQ.y", "RootQ.z", "RootQ.w"];
        Assert.Equal(body, bindings.Take(7).Select(static binding => binding.propertyName));
        Assert.Equal(95 + (4 * 7), bindings.Length - 7);
        Assert.All(bindings, static binding => Assert.Equal((typeof(Animator), ""), (binding.type, binding.path)));
        Assert.Contains(bindings, static binding => binding.propertyName == "RightHand.Little.3 Stretched");
        string[] goals = ["LeftFootT.x", "LeftFootQ.w", "RightFootT.y", "RightFootQ.x", "LeftHandT.z", "RightHandQ.z"];
        Assert.All(goals, goal => Assert.Contains(bindings, binding => binding.propertyName == goal));
        Assert.DoesNotContain(bindings, static binding => binding.propertyName.StartsWith("Left Index", StringComparison.Ordinal));
        Assert.True(AnimationUtility.GetAnimationClipSettings(clip).keepOriginalPositionY);
        Assert.True(clip.isHumanMotion);

        // Within the tolerance at every frame, with fewer keys.
        float scale = 0.01f;
        int keys = 0;
        for (int i = 0; i < bindings.Length; i++)
        {
            AnimationCurve curve = AnimationUtility.GetEditorCurve(clip, bindings[i])!;
            keys += curve.length;
            for (int frame = 0; frame < take.FrameCount; frame++)
                Assert.Equal(take.GetValue(frame, i), curve.Evaluate(take.GetTime(frame)), 0.2f * scale);
        }

        Assert.True(keys < take.FrameCount * bindings.Length / 2, $"{keys} keys");
    }

    [Fact]
    public void A_clip_is_saved_although_a_handler_throws()
    {
        MocapSource source = Stage.AddSimulator();
        ClipRecorder recorder = AddFigure(source);
        _loop.RunUntil(() => Stage.IsLive(source));
        recorder.Finished += static _ => throw new InvalidOperationException("finished");
        Assert.True(recorder.StartRecording());
        _loop.Frames(3);

        recorder.enabled = false;

        Assert.NotNull(AssetDatabase.LoadAssetAtPath<AnimationClip>(recorder.SavedPath));
        Assert.Equal("finished", Assert.Single(ConsoleLog.Problems).Exception!.Message);
    }

    [Fact]
    public void A_generic_clip_restores_every_transform()
    {
        MocapSource source = Stage.AddSimulator();
        ClipRecorder recorder = AddFigure(source);
        recorder.Kind = ClipKind.Generic;
        recorder.KeyTolerance = 0;
        _loop.RunUntil(() => Stage.IsLive(source));
        recorder.StartRecording();
        _loop.RunFor(0.3f);

        // Long enough after the last frame to be recorded.
        _loop.Frame(1 / 30f);
        HumanoidFigure figure = recorder.GetComponent<FigureBuilder>().Figure!;
        ClipTake take = recorder.Take!;
        recorder.StopRecording();

        AnimationClip clip = AssetDatabase.LoadAssetAtPath<AnimationClip>(recorder.SavedPath)!;
        EditorCurveBinding[] bindings = AnimationUtility.GetCurveBindings(clip);
        Assert.Equal(3 + (59 * 4), bindings.Length);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            string path = PathOf(figure, bone);
            Quaternion last = figure.GetBone(bone).localRotation;
            var played = new Quaternion(Last(path, "m_LocalRotation.x"), Last(path, "m_LocalRotation.y"), Last(path, "m_LocalRotation.z"), Last(path, "m_LocalRotation.w"));
            Assert.True(Quaternion.Angle(last, played) < 0.1f, $"{bone}: {Quaternion.Angle(last, played)} degrees");
        }

        Assert.Equal(figure.GetBone(Bone.Hips).localPosition.y, Last("Hips", "m_LocalPosition.y"), 1e-4f);

        float Last(string path, string property)
        {
            AnimationCurve curve = AnimationUtility.GetEditorCurve(clip, EditorCurveBinding.FloatCurve(path, typeof(Transform), property))!;
            Assert.Equal(take.FrameCount, curve.length);
            return curve[curve.length - 1].value;
        }
    }

    [Fact]
    public void Leaving_play_mode_saves_the_take()
    {
        ClipRecorder recorder = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<ClipRecorder>();
        recorder.Folder = "Takes/Monday";
        recorder.FileName = "{source}";
        recorder.RecordOnPlay = true;
        _loop.Frames(5);

        _loop.ExitPlayMode();

        Assert.NotNull(AssetDatabase.LoadAssetAtPath<AnimationClip>("Assets/Takes/Monday/Figure.anim"));
    }

    [Fact]
    public void A_folder_outside_the_project_is_refused()
    {
        ClipRecorder recorder = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<ClipRecorder>();
        recorder.Folder = "../elsewhere";
        recorder.StartRecording();
        _loop.Frame();
        recorder.StopRecording();

        Assert.Contains("Assets", recorder.Problem);
        Assert.Empty(recorder.SavedPath);
    }

    [Theory]
    [InlineData(0, 100)]
    [InlineData(0.001f, 60)]
    public void Redundant_keys_are_left_out(float tolerance, int most)
    {
        static float Value(int frame, int value) => frame < 50 ? 0 : Mathf.Sin((frame - 50) * 0.1f);

        IReadOnlyList<int> kept = KeyReduction.Keep(100, 1, static frame => frame / 60f, Value, tolerance);

        Assert.Equal(0, kept[0]);
        Assert.Equal(99, kept[^1]);
        Assert.True(kept.Count <= most);
        for (int i = 1; i < kept.Count; i++)
        {
            for (int frame = kept[i - 1]; frame <= kept[i]; frame++)
            {
                float part = (float)(frame - kept[i - 1]) / (kept[i] - kept[i - 1]);
                Assert.True(Math.Abs(Mathf.Lerp(Value(kept[i - 1], 0), Value(kept[i], 0), part) - Value(frame, 0)) <= tolerance + 1e-6f);
            }
        }
    }

    private static ClipRecorder AddFigure(MocapSource source)
    {
        var holder = new GameObject("Ann");
        holder.AddComponent<HumanoidDriver>().Source = source;
        holder.AddComponent<FigureBuilder>();
        return holder.AddComponent<ClipRecorder>();
    }

    private static string PathOf(HumanoidFigure figure, Bone bone)
    {
        string path = "";
        for (Bone? step = bone; step is { } known; step = BoneHierarchy.GetParent(known, figure.Body.Variant))
            path = BoneHierarchy.GetName(known, figure.Body.Variant) + (path.Length == 0 ? "" : "/" + path);

        return path;
    }
}
