using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Recorders;

public sealed partial class ClipRecorderTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public ClipRecorderTests() => RegisterEditor();

    public void Dispose() => _loop.Dispose();

    [Theory]
    [InlineData("Left Index 1 Stretched", "LeftHand.Index.1 Stretched")]
    [InlineData("Left Thumb Spread", "LeftHand.Thumb.Spread")]
    [InlineData("Right Little 3 Stretched", "RightHand.Little.3 Stretched")]
    [InlineData("Spine Front-Back", "Spine Front-Back")]
    [InlineData("Left Hand Down-Up", "Left Hand Down-Up")]
    public void Fingers_have_other_names_in_clips(string muscle, string property) => Assert.Equal(property, HumanoidSampler.GetPropertyName(muscle));

    [Fact]
    public void A_frame_captures_the_characters_pose()
    {
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        ClipRecorder recorder = figure.Root.AddComponent<ClipRecorder>();
        recorder.Kind = ClipKind.Generic;
        Assert.True(recorder.StartRecording());
        Transform arm = figure.GetBone(Bone.LeftArm);
        for (int i = 0; i < 30; i++)
        {
            arm.localRotation = Quaternion.Euler(0, 0, 3 * i);
            figure.GetBone(Bone.Hips).localPosition = new Vector3(0.01f * i, 0.8f, 0);
            _loop.Frame();
        }

        ClipTake take = recorder.Take!;
        Assert.Equal(30, take.FrameCount);
        Assert.Equal(29 / 60f, take.Length, 0.001f);
        Assert.Equal(3 + (59 * 4), take.ValueCount);
        ClipProperty[] properties = [.. take.Properties];
        Assert.Equal("Hips", properties[0].Path);
        Assert.Equal("m_LocalPosition", properties[0].Name);
        int place = Array.FindIndex(properties, static property => property.Path == "Hips/Spine/Spine1/Spine2/LeftShoulder/LeftArm");
        int first = properties.Take(place).Sum(static property => property.Components.Count);
        Assert.Equal(0.2f, take.GetValue(20, 0), 1e-5f);
        Quaternion wanted = Quaternion.Euler(0, 0, 60);
        Assert.Equal(wanted.z, take.GetValue(20, first + 2), 1e-5f);
        Assert.Equal(wanted.w, take.GetValue(20, first + 3), 1e-5f);
    }

    [Fact]
    public void Rotations_are_continuous()
    {
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        ClipRecorder recorder = figure.Root.AddComponent<ClipRecorder>();
        recorder.Kind = ClipKind.Generic;
        recorder.StartRecording();
        for (int i = 0; i < 80; i++)
        {
            // Two full turns, with either of the two quaternions.
            var turn = Quaternion.Euler(0, 9 * i, 0);
            figure.GetBone(Bone.Hips).localRotation = i % 3 == 0 ? new Quaternion(-turn.x, -turn.y, -turn.z, -turn.w) : turn;
            _loop.Frame();
        }

        ClipTake take = recorder.Take!;
        for (int frame = 1; frame < take.FrameCount; frame++)
        {
            for (int value = 3; value < 7; value++)
                Assert.True(Math.Abs(take.GetValue(frame, value) - take.GetValue(frame - 1, value)) < 0.1f);
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_humanoid_take_does_not_depend_on_where_the_character_stands(bool isBodyInWorld)
    {
        HumanPoseHandler.BodyIsInWorld = isBodyInWorld;
        float[][] values = new float[2][];
        for (int i = 0; i < 2; i++)
        {
            Transform parent = new GameObject("Parent").transform;
            parent.SetPositionAndRotation(new Vector3(5 * i, 0, -3 * i), Quaternion.Euler(0, 120 * i, 0));
            parent.localScale = (1 + i) * Vector3.one;
            HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault(), parent: parent);
            figure.GetBone(Bone.LeftForeArm).localRotation = Quaternion.Euler(0, 40, 0);
            ClipRecorder recorder = figure.Root.AddComponent<ClipRecorder>();
            recorder.StartRecording();
            _loop.Frame();
            values[i] = [.. Enumerable.Range(0, recorder.Take!.ValueCount).Select(value => recorder.Take.GetValue(0, value))];
            Assert.Equal(7 + 95 + (4 * 7), values[i].Length);
            Assert.Equal(new Vector3(5 * i, 0, -3 * i), figure.Root.transform.position);
        }

        for (int i = 0; i < values[0].Length; i++)
            Assert.Equal(values[0][i], values[1][i], 1e-4f);

        Assert.Contains(values[0].Skip(7).Take(95), static muscle => Math.Abs(muscle) > 0.1f);
    }

    [Theory]
    [InlineData(ClipKind.Humanoid, false)]
    [InlineData(ClipKind.Humanoid, true)]
    [InlineData(ClipKind.Generic, false)]
    public void The_way_of_a_root_that_moves_belongs_to_the_clip(ClipKind kind, bool isBodyInWorld)
    {
        HumanPoseHandler.BodyIsInWorld = isBodyInWorld;
        ClipTake[] takes = new ClipTake[2];
        for (int i = 0; i < 2; i++)
        {
            Transform parent = new GameObject("Parent").transform;
            parent.SetPositionAndRotation(new Vector3(4, 0, 1), Quaternion.Euler(0, 70, 0));
            HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault(), parent: parent);
            ClipRecorder recorder = figure.Root.AddComponent<ClipRecorder>();
            recorder.Kind = kind;
            recorder.StartRecording();
            _loop.Frame();

            // The same way through the scene, of the root with the hips and of the hips alone.
            Transform hips = figure.GetBone(Bone.Hips);
            Transform root = figure.Root.transform;
            var way = new Vector3(2, 0, -1);
            var turn = Quaternion.Euler(0, 50, 0);
            Vector3 place = root.position + way + (turn * (hips.position - root.position));
            Quaternion rotation = turn * hips.rotation;
            if (i == 0)
                root.SetPositionAndRotation(root.position + way, turn * root.rotation);
            else
                hips.SetPositionAndRotation(place, rotation);

            Assert.True((hips.position - place).magnitude < 1e-4f);
            _loop.Frame();
            takes[i] = recorder.Take!;
        }

        int values = kind == ClipKind.Humanoid ? 7 + 95 : takes[0].ValueCount;
        for (int value = 0; value < values; value++)
            Assert.Equal(takes[1].GetValue(1, value), takes[0].GetValue(1, value), 1e-3f);

        Assert.True(Math.Abs(takes[0].GetValue(1, 0) - takes[0].GetValue(0, 0)) > 0.5f);
    }

    [Fact]
    public void Goals_are_at_the_soles_and_hands()
    {
        TestFigure figure = TestFigure.Build("Ann");
        ClipRecorder recorder = figure.Root.AddComponent<ClipRecorder>();
        recorder.StartRecording();
        _loop.Frame();

        float scale = figure.Animator.humanScale;
        Transform root = figure.Root.transform;
        Vector3 body = Position("Root") * scale;
        Quaternion turn = Rotation("Root");
        Assert.Equal(0, (End("LeftHand", Vector3.zero) - root.InverseTransformPoint(figure[Bone.LeftHand].position)).magnitude, 1e-4f);
        Assert.Equal(0, (End("RightHand", Vector3.zero) - root.InverseTransformPoint(figure[Bone.RightHand].position)).magnitude, 1e-4f);
        Assert.Equal(0, (End("LeftFoot", Vector3.left) - root.InverseTransformPoint(figure[Bone.LeftFoot].position)).magnitude, 1e-4f);
        Assert.Equal(0, (End("RightFoot", Vector3.left) - root.InverseTransformPoint(figure[Bone.RightFoot].position)).magnitude, 1e-4f);

        // x of a foot's goal points from the ankle to the sole, which is below it in the T-pose.
        Vector3 down = Quaternion.Inverse(figure.Turn(Bone.LeftFoot)) * turn * Rotation("LeftFoot") * Vector3.right;
        Assert.Equal(0, (down - Vector3.down).magnitude, 1e-3f);

        Vector3 End(string goal, Vector3 fromSole) =>
            body + (turn * ((Position(goal) * scale) + (Rotation(goal) * fromSole * figure.Animator.leftFeetBottomHeight)));
        Vector3 Position(string name) => new(Value(name + "T", 0), Value(name + "T", 1), Value(name + "T", 2));
        Quaternion Rotation(string name) => new(Value(name + "Q", 0), Value(name + "Q", 1), Value(name + "Q", 2), Value(name + "Q", 3));
        float Value(string property, int component)
        {
            ClipProperty[] properties = [.. recorder.Take!.Properties];
            int place = Array.FindIndex(properties, item => item.Name == property);
            return recorder.Take.GetValue(0, properties.Take(place).Sum(static item => item.Components.Count) + component);
        }
    }

    [Fact]
    public void The_frame_limit_is_kept()
    {
        ClipRecorder recorder = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<ClipRecorder>();
        recorder.FrameRate = 30;
        recorder.StartRecording();

        _loop.Frames(241, 1 / 120f);

        Assert.InRange(recorder.Take!.FrameCount, 59, 62);
        Assert.Equal(2, recorder.Take.Length, 0.05f);
    }

    [Fact]
    public void A_capture_makes_a_clip_in_the_time_of_the_game()
    {
        ClipRecorder recorder = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<ClipRecorder>();
        Time.captureFramerate = 30;
        recorder.StartRecording();

        _loop.Frames(31, 0.5f);

        Assert.Equal(31, recorder.Take!.FrameCount);
        Assert.Equal(1, recorder.Take.Length, 1e-4f);
    }

    [Theory]
    [InlineData(ClipKind.Humanoid)]
    [InlineData(ClipKind.Generic)]
    public void A_take_ends_with_its_character(ClipKind kind)
    {
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        ClipRecorder recorder = new GameObject("Recorder").AddComponent<ClipRecorder>();
        (recorder.Animator, recorder.Kind) = (figure.Root.GetComponent<Animator>(), kind);
        Assert.True(recorder.StartRecording());
        _loop.Frames(3);

        Object.DestroyImmediate(figure.Root);
        _loop.Frames(2);

        Assert.False(recorder.IsRecording);
        Assert.Equal(3, recorder.Take!.FrameCount);
        Assert.NotEmpty(recorder.Problem);
        Assert.Empty(ConsoleLog.Problems);
    }

    [Theory]
    [InlineData(ClipKind.Humanoid)]
    [InlineData(ClipKind.Generic)]
    public void A_take_goes_on_when_the_figure_is_built_again_in_the_performers_sizes(ClipKind kind)
    {
        var actor = new StandingActor(Figures.HumanoidFigureTests.Tall(SkeletonVariant.Neck1));
        using Broadcaster server = Stage.Broadcast(actor);
        var holder = new GameObject("Ann");
        HumanoidDriver driver = holder.AddComponent<HumanoidDriver>();
        driver.Source = Stage.AddClient(server);
        FigureBuilder builder = holder.AddComponent<FigureBuilder>();
        ClipRecorder recorder = holder.AddComponent<ClipRecorder>();
        (recorder.Kind, recorder.RecordOnPlay) = (kind, true);
        _loop.Frame();
        Assert.True(recorder.IsRecording, recorder.Problem);
        HumanoidFigure first = builder.Figure!;
        holder.transform.position = new Vector3(0, 0, 3);

        _loop.RunUntil(() => first.IsDestroyed && driver.IsDriving);
        _loop.Frames(10);

        Assert.True(recorder.IsRecording, recorder.Problem);
        Assert.Empty(recorder.Problem);

        // The way since the first frame belongs to the clip.
        ClipTake take = recorder.Take!;
        Assert.Equal(0, take.GetValue(0, 2), 0.1f);
        Assert.True(take.GetValue(take.FrameCount - 1, 2) > 1.5f, "The new figure begins a way of its own.");
        Assert.DoesNotContain(ConsoleLog.Entries, static entry => entry.Type is LogType.Error or LogType.Exception);
    }

    [Fact]
    public void A_transform_that_goes_during_a_generic_take_keeps_its_last_rotation()
    {
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault());
        Transform sword = new GameObject("Sword").transform;
        sword.SetParent(figure.GetBone(Bone.RightHand), worldPositionStays: false);
        sword.localRotation = Quaternion.Euler(0, 0, 60);
        ClipRecorder recorder = figure.Root.AddComponent<ClipRecorder>();
        recorder.Kind = ClipKind.Generic;
        Assert.True(recorder.StartRecording());
        _loop.Frames(2);

        Object.DestroyImmediate(sword.gameObject);
        _loop.Frames(2);

        ClipTake take = recorder.Take!;
        Assert.Equal(4, take.FrameCount);
        for (int value = 0; value < take.ValueCount; value++)
            Assert.Equal(take.GetValue(1, value), take.GetValue(3, value), 1e-5f);

        Assert.Empty(ConsoleLog.Problems);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_generic_take_has_the_bones_that_the_driver_moves(bool isDriverAbove)
    {
        GameObject rig = GenericRig.BuildAfterMesh(out Dictionary<Bone, Transform> bones);
        var holder = new GameObject("Ann");
        rig.transform.SetParent(holder.transform);
        (isDriverAbove ? holder : rig).AddComponent<GenericRigDriver>();
        ClipRecorder recorder = rig.AddComponent<ClipRecorder>();
        recorder.Kind = ClipKind.Generic;
        Assert.True(recorder.StartRecording());

        ClipProperty[] properties = [.. recorder.Take!.Properties];
        Assert.Equal(1 + bones.Count, properties.Length);
        Assert.Equal("Hips", properties[0].Path);
        Assert.All(bones, bone => Assert.Contains(properties, property => property.Path.Split('/')[^1] == bone.Value.name));
    }

    [Fact]
    public void A_prop_that_a_figure_holds_has_its_own_bones()
    {
        GameObject rig = GenericRig.BuildAfterMesh(out Dictionary<Bone, Transform> bones);
        rig.AddComponent<GenericRigDriver>();
        Transform flail = new GameObject("Flail").transform;
        flail.SetParent(bones[Bone.RightHand], worldPositionStays: false);
        new GameObject("Chain").transform.SetParent(flail, worldPositionStays: false);
        ClipRecorder recorder = flail.gameObject.AddComponent<ClipRecorder>();
        recorder.Kind = ClipKind.Generic;
        Assert.True(recorder.StartRecording());

        Assert.All(recorder.Take!.Properties, static property => Assert.Equal("Chain", property.Path));
    }

    [Fact]
    public void Invalid_settings_are_reported()
    {
        ClipRecorder recorder = new GameObject("Nothing").AddComponent<ClipRecorder>();
        Assert.False(recorder.StartRecording());
        Assert.Contains("Animator", recorder.Problem);

        recorder.gameObject.AddComponent<Animator>();
        Assert.False(recorder.StartRecording());
        Assert.Contains("Humanoid", recorder.Problem);

        recorder.Kind = ClipKind.Generic;
        Assert.False(recorder.StartRecording());
        Assert.Contains("Hips", recorder.Problem);
    }

    static partial void RegisterEditor();
}
