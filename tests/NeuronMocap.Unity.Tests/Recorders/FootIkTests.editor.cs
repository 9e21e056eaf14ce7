using NeuronMocap.Skeleton;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Tests.Drivers;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Recorders;

/// <summary>Humanoid clips are played with Foot IK, as Timeline does unless it is switched off.</summary>
public sealed class FootIkTests : IDisposable
{
    private const int Frames = 20;

    private static readonly Bone[] Legs = [Bone.LeftUpLeg, Bone.LeftLeg, Bone.LeftFoot, Bone.RightUpLeg, Bone.RightLeg, Bone.RightFoot];

    private readonly PlayerLoop _loop = new();

    public FootIkTests() => ClipSaver.Register();

    public void Dispose() => _loop.Dispose();

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Legs_play_as_they_were_recorded(bool footIk)
    {
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        Transform root = figure.Root.transform;
        root.SetPositionAndRotation(new Vector3(2, 0, 1), Quaternion.Euler(0, 70, 0));
        Animator animator = figure.Root.GetComponent<Animator>();
        Transform[] legs = [.. Legs.Select(figure.GetBone)];
        (AnimationClip clip, Pose[][] recorded) = Record(figure.Root, legs, frame =>
        {
            figure.GetBone(Bone.Hips).localPosition = new Vector3(0, 0.8f, 0.02f * frame);
            figure.GetBone(Bone.Hips).localRotation = Quaternion.Euler(0, 3 * frame, 0);
            figure.GetBone(Bone.LeftUpLeg).localRotation = Quaternion.Euler(-2 * frame, 5, 0);
            figure.GetBone(Bone.LeftLeg).localRotation = Quaternion.Euler(3 * frame, 0, 0);
            figure.GetBone(Bone.LeftFoot).localRotation = Quaternion.Euler(-frame, 0, 0);
            figure.GetBone(Bone.RightUpLeg).localRotation = Quaternion.Euler(frame, 0, -frame);
        });

        root.SetPositionAndRotation(new Vector3(-1, 1, 0), Quaternion.Euler(0, -20, 0));
        for (int frame = 0; frame < Frames; frame++)
        {
            ClipPlayback.Apply(clip, animator, frame / 60f, footIk);
            for (int i = 0; i < legs.Length; i++)
                AssertSame(recorded[frame][i], RelativeTo(root, legs[i]), $"{Legs[i]} in frame {frame}");
        }
    }

    [Fact]
    public void Feet_reach_their_goals_on_a_scaled_rig_with_axes_of_its_own()
    {
        TestFigure figure = TestFigure.Build("Ann");
        Transform[] feet = [figure[Bone.LeftFoot], figure[Bone.RightFoot]];
        (AnimationClip clip, Pose[][] recorded) = Record(figure.Root, feet, frame =>
        {
            figure[Bone.Hips].Rotate(2, 1, 0);
            figure[Bone.LeftLeg].Rotate(1, 2, 3);
            figure[Bone.RightUpLeg].Rotate(3, 0, -1);
        });

        for (int frame = 0; frame < Frames; frame++)
        {
            ClipPlayback.Apply(clip, figure.Animator, frame / 60f);
            for (int i = 0; i < feet.Length; i++)
                AssertSame(recorded[frame][i], RelativeTo(figure.Root.transform, feet[i]), $"{feet[i].name} in frame {frame}");
        }
    }

    [Fact]
    public void Without_goals_in_the_clip_the_legs_collapse()
    {
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        Transform foot = figure.GetBone(Bone.LeftFoot);
        (AnimationClip clip, _) = Record(figure.Root, [foot], static _ => { });
        foreach (EditorCurveBinding binding in AnimationUtility.GetCurveBindings(clip).Where(static binding => binding.propertyName.StartsWith("LeftFoot", StringComparison.Ordinal)))
            AnimationUtility.SetEditorCurve(clip, binding, null);

        ClipPlayback.Apply(clip, figure.Root.GetComponent<Animator>(), 0);

        Assert.True((foot.position - figure.GetBone(Bone.Hips).position).magnitude < 0.3f);
        Assert.True((figure.GetBone(Bone.RightFoot).position - figure.GetBone(Bone.Hips).position).magnitude > 0.6f);
    }

    private static Pose RelativeTo(Transform root, Transform item) =>
        new(root.InverseTransformPoint(item.position), Quaternion.Inverse(root.rotation) * item.rotation);

    private static void AssertSame(Pose expected, Pose actual, string what)
    {
        float distance = (expected.position - actual.position).magnitude;
        float angle = Quaternion.Angle(expected.rotation, actual.rotation);
        Assert.True(distance < 0.002f && angle < 0.5f, $"{what} is {distance} m and {angle} degrees away.");
    }

    // Returns the clip, and the poses of some bones in each frame, relative to the root.
    private (AnimationClip Clip, Pose[][] Poses) Record(GameObject character, Transform[] bones, Action<int> move)
    {
        ClipRecorder recorder = character.AddComponent<ClipRecorder>();
        recorder.KeyTolerance = 0;
        recorder.StartRecording();
        var poses = new Pose[Frames][];
        for (int frame = 0; frame < Frames; frame++)
        {
            move(frame);
            _loop.Frame();
            poses[frame] = [.. bones.Select(bone => RelativeTo(character.transform, bone))];
        }

        recorder.StopRecording();
        Assert.Empty(recorder.Problem);
        return (AssetDatabase.LoadAssetAtPath<AnimationClip>(recorder.SavedPath)!, poses);
    }
}
