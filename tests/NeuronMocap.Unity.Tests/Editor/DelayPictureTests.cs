using NeuronMocap.Motion;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

// The pictures of the jitter buffer and of the smoothing in the inspectors.
public class DelayPictureTests
{
    private static readonly MotionHistory Example = MotionHistory.CreateExample();

    [Fact]
    public void The_example_is_always_the_same()
    {
        MotionHistory again = MotionHistory.CreateExample();

        Assert.Equal(180, Example.Frames.Count, 5d);
        Assert.Equal(Example.Frames.Select(static frame => frame.Time), again.Frames.Select(static frame => frame.Time));
        Assert.All(Example.Frames.Zip(again.Frames), static pair => Assert.Equal(pair.First.Pose, pair.Second.Pose));
    }

    [Fact]
    public void The_history_keeps_three_seconds()
    {
        var history = new MotionHistory();
        for (int i = 0; i < 1000; i++)
            history.Add(i / 100.0, new BoneTransform[BoneHierarchy.BoneCount]);

        history.Add(9.99, new BoneTransform[BoneHierarchy.BoneCount]);
        Assert.Equal(9.99, history.Frames[^1].Time);
        Assert.InRange(history.Frames[^1].Time - history.Frames[0].Time, 2.9, MotionHistory.Length + 0.02);
        Assert.Equal(history.Frames.Select(static frame => frame.Pose).Distinct().Count(), history.Frames.Count);
    }

    // A bone that turns evenly, and frames that arrive evenly: the shown curve is the received one, moved by the delay.
    [Theory]
    [InlineData(30)]
    [InlineData(100)]
    public void The_buffer_moves_the_curve_by_its_delay(float delay)
    {
        var curves = new MotionCurves(Turning(degreesPerSecond: 40), Bone.RightArm);

        List<Vector2> shown = curves.Resampled(new SamplingSettings(true, delay, PoseInterpolationMethod.Linear), out long late);

        Assert.NotEmpty(shown);
        Assert.All(shown, point => Assert.Equal(40 * (point.x + 1 - (delay / 1000)), point.y, 0.2f));
        Assert.All(curves.Received(), static point => Assert.Equal(40 * (point.x + 1), point.y, 0.2f));
        Assert.Equal(0, late);
    }

    [Fact]
    public void A_delay_shorter_than_the_jitter_makes_frames_late()
    {
        var curves = new MotionCurves(Example, Bone.RightArm);

        curves.Resampled(new SamplingSettings(true, 2, PoseInterpolationMethod.Cubic), out long tooShort);
        curves.Resampled(new SamplingSettings(true, 40, PoseInterpolationMethod.Cubic), out long enough);

        Assert.True(tooShort > 10, $"{tooShort} late frames");
        Assert.Equal(0, enough);
    }

    [Fact]
    public void Without_resampling_the_newest_frame_is_shown()
    {
        var curves = new MotionCurves(Example, Bone.RightArm);
        float[] received = [.. curves.Received().Select(static point => point.y)];

        List<Vector2> shown = curves.Resampled(new SamplingSettings(false, 30, PoseInterpolationMethod.Cubic), out long late);

        Assert.Equal(0, late);
        Assert.All(shown.Skip(2), point => Assert.Contains(received, value => Mathf.Abs(value - point.y) < 0.001f));
    }

    [Fact]
    public void Smoothing_removes_the_noise_of_a_bone_at_rest_and_delays_its_motion()
    {
        var strong = new PartSmoothing();
        strong.Set(BodyParts.All, new SmoothingAmount(1, 0));
        var still = new MotionHistory();
        for (int i = 0; i < 180; i++)
            still.Add(i / 60.0, Posed(Mathf.Sin(i * 2.1f)));

        var curves = new MotionCurves(still, Bone.RightArm);
        Assert.True(Range(curves.Smoothed(strong)) < 0.2f * Range(curves.Received()), "The noise is still there.");

        // At a steady speed, the curve is later by the delay of the settings.
        float delay = (float)strong.Get(BodyParts.RightArm).ToSettings().GetDelay() / 1000;
        Vector2 last = new MotionCurves(Turning(degreesPerSecond: 40), Bone.RightArm).Smoothed(strong)[^1];
        Assert.Equal(40 * (last.x + 1 - delay), last.y, 0.5f);
    }

    [Fact]
    public void The_inspectors_draw_the_example_until_motion_arrives()
    {
        using var world = new EditorWorld();
        MocapSource source = world.AddSource(static source => source.Delay = 35);
        UnityEditor.Editor inspector = world.Inspect(source);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Empty(ImmediateGui.Lines);

        ImmediateGui.Click(inspector.OnInspectorGUI, DelayPicture.BufferLabel);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        AssertPicture();
        Assert.Matches(@"^Example motion\. Orange: what figures show, 35 ms after the frames in grey\. \d+ of 1\d\d frames came too late\.$", EditorWorld.Find("Example").Label);

        source.Resample = false;
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Contains("No delay is added", EditorWorld.Find("Example").Label, StringComparison.Ordinal);
    }

    [Fact]
    public void The_smoothing_of_each_part_has_a_picture()
    {
        using var world = new EditorWorld();
        HumanoidDriver driver = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<HumanoidDriver>();
        UnityEditor.Editor inspector = world.Inspect(driver);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Empty(ImmediateGui.Lines);

        driver.Smoothing = true;
        driver.PartSmoothing.Set(BodyParts.Legs, new SmoothingAmount(1, 1));
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        AssertPicture();
        Assert.Contains("up to 53 ms after", EditorWorld.Find("Example").Label, StringComparison.Ordinal);
        GuiLine[] arms = [.. ImmediateGui.Lines];

        ImmediateGui.Set(inspector.OnInspectorGUI, DelayPicture.PartLabel, "Legs");
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Contains("up to 159 ms after", EditorWorld.Find("Example").Label, StringComparison.Ordinal);
        Assert.NotEqual(arms.Select(static line => line.To), ImmediateGui.Lines.Select(static line => line.To));
    }

    [Fact]
    public void Live_motion_replaces_the_example()
    {
        using var world = new EditorWorld(play: true);
        MocapSource source = Stage.AddSimulator();
        UnityEditor.Editor inspector = world.Inspect(source);
        ImmediateGui.Click(inspector.OnInspectorGUI, DelayPicture.BufferLabel);
        world.Loop.RunUntil(() =>
        {
            EditorApplication.Tick(0.01);
            ImmediateGui.Draw(inspector.OnInspectorGUI);
            return source.Performers.Count > 0
                && EditorWorld.Controls.Any(control => control.Label.StartsWith($"{source.Performers[0]}. Orange", StringComparison.Ordinal));
        });

        AssertPicture();
        Object.DestroyImmediate(inspector);
        Assert.All(source.Performers, static performer => Assert.True(performer.Stream.IsWatched));
    }

    private static void AssertPicture()
    {
        Rect rect = ImmediateGui.FreeRect;
        Assert.Contains(ImmediateGui.Lines, static line => line.Color == CurvePicture.Received);
        Assert.Contains(ImmediateGui.Lines, static line => line.Color == CurvePicture.Shown);
        Assert.All(ImmediateGui.Lines, line => Assert.True(rect.Contains(line.To), $"{line.To} is outside."));
    }

    private static MotionHistory Turning(float degreesPerSecond)
    {
        var history = new MotionHistory();
        for (int i = 0; i < 180; i++)
            history.Add(i / 60.0, Posed(degreesPerSecond * i / 60));

        return history;
    }

    private static BoneTransform[] Posed(float degrees)
    {
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        SkeletonBody.GetDefault().CopyRestPose(pose);
        var turn = System.Numerics.Quaternion.CreateFromAxisAngle(System.Numerics.Vector3.UnitZ, degrees * Mathf.Deg2Rad);
        pose[(int)Bone.RightArm] = new BoneTransform(pose[(int)Bone.RightArm].Position, turn);
        return pose;
    }

    private static float Range(List<Vector2> points) => points.Max(static point => point.y) - points.Min(static point => point.y);
}
