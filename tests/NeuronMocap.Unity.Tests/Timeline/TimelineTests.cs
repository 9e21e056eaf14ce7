using NeuronMocap.Bvh;
using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;
using NeuronMocap.Unity.Timeline;
using UnityEngine.Playables;
using UnityEngine.Timeline;
using Numerics = System.Numerics;

namespace NeuronMocap.Unity.Tests.Timeline;

public sealed partial class TimelineTests : SourceFixture
{
    private const double Start = 2;

    private static readonly string Bvh = Path.Combine(Repository.Root, "samples", "takes", "walk.bvh");
    private static readonly string Recording = Path.Combine(Repository.Root, "samples", "takes", "walk.nmrec");

    private MotionTrack _track = null!;
    private TestFigure _figure = null!;
    private HumanoidDriver _driver = null!;
    private PlayableDirector _director = null!;

    [Theory]
    [InlineData(true, true)]
    [InlineData(false, true)]
    [InlineData(true, false)]
    [InlineData(false, false)]
    public void Scrubbing_in_any_order_shows_exactly_the_pose_of_the_file(bool isBvh, bool plays)
    {
        Begin(plays);
        MotionSource take = isBvh ? new BvhSource(BvhDocument.Load(Bvh)) : RecordingSource.Load(Recording);
        TimelineClip clip = AddClip(isBvh ? Bvh : Recording, Start);
        Assert.Equal(take.FrameCount!.Value / take.FrameRate, clip.duration, 1e-9);

        foreach (long frame in (long[])[0, 7, 3, take.FrameCount.Value - 1, 20, 19, 1])
        {
            ShowAt(Start + (frame / take.FrameRate));
            AssertPose(Retarget(take, frame));
        }

        // Halfway between two frames.
        ShowAt(Start + (10.5 / take.FrameRate));
        AssertPose(Mix(Retarget(take, 10), Retarget(take, 11), 0.5f), 0.05f);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void Clip_in_and_speed_choose_the_frame()
    {
        Begin(play: false);
        var take = new BvhSource(BvhDocument.Load(Bvh));
        TimelineClip clip = AddClip(Bvh, Start);
        (clip.clipIn, clip.timeScale) = (10 / take.FrameRate, 2);

        ShowAt(Start);
        AssertPose(Retarget(take, 10));
        ShowAt(Start + (5 / take.FrameRate));
        AssertPose(Retarget(take, 20));
    }

    [Fact]
    public void Two_clips_blend_by_their_weights()
    {
        Begin(play: false);
        var take = new BvhSource(BvhDocument.Load(Bvh));
        TimelineClip first = AddClip(Bvh, 0);
        TimelineClip second = AddClip(Bvh, 0.5);
        (first.duration, second.duration) = (1, 1);
        second.clipIn = 12 / take.FrameRate;

        // The clips overlap from 0.5 to 1.
        double time = 0.5 + (7 / take.FrameRate);
        ShowAt(time);

        float part = (float)((time - 0.5) / 0.5);
        long frame = (long)Math.Round(time * take.FrameRate);
        RetargetedPose from = Retarget(take, time * take.FrameRate);
        Assert.Equal(frame, time * take.FrameRate, 1e-6);
        AssertPose(Mix(from, Retarget(take, 12 + 7), part), 0.05f);
    }

    [Fact]
    public void An_eased_clip_mixes_with_the_rest_pose()
    {
        Begin(play: false);
        var take = new BvhSource(BvhDocument.Load(Bvh));
        TimelineClip clip = AddClip(Bvh, 0);
        clip.easeInDuration = 20 / take.FrameRate;

        // Only at first, the pose in the scene counts as that of an Animator.
        ShowAt(30 / take.FrameRate);
        ShowAt(10 / take.FrameRate);

        AssertPose(Mix(new RetargetedPose(_driver.TargetRig!), Retarget(take, 10), 0.5f), 0.05f);
    }

    [Fact]
    public void Outside_clips_and_after_a_preview_the_figure_has_its_pose_of_the_scene()
    {
        Begin(play: false);
        AddClip(Bvh, Start);
        Transform[] nodes = _driver.FindRig(out _)!.Nodes;
        (Vector3 Position, Quaternion Rotation)[] scene = Array.ConvertAll(nodes, static node => (node.localPosition, node.localRotation));
        ShowAt(Start + 0.1);
        Assert.True(_driver.IsPosed);
        Assert.False(IsAsInScene());

        ShowAt(Start - 1);
        Assert.False(_driver.IsPosed);
        Assert.True(IsAsInScene());

        ShowAt(Start + 0.1);
        ShowAt(Start + 0.2);
        _director.Stop();
        Assert.False(_driver.IsPosed);
        Assert.True(IsAsInScene());

        bool IsAsInScene() => nodes.Zip(scene, static (node, place) =>
            (node.localPosition - place.Position).magnitude < 1e-5f && Quaternion.Angle(node.localRotation, place.Rotation) < 0.1f).All(static isSame => isSame);
    }

    [Fact]
    public void A_playing_clip_takes_the_figure_from_its_performer_and_gives_it_back()
    {
        Begin(play: true);
        _driver.Source = AddSimulator();
        Loop.RunUntil(() => _driver.IsDriving);
        var take = new BvhSource(BvhDocument.Load(Bvh));
        AddClip(Bvh, 0);

        ShowAt(0);
        Loop.Frame();
        Assert.False(_driver.IsDriving);
        Assert.Equal(string.Empty, _driver.Problem);
        AssertPose(Retarget(take, 0));

        _director.Stop();
        Loop.Frame();
        Assert.True(_driver.IsDriving);
        Assert.Equal(0, Quaternion.Angle(_driver.Performer!.GetRotation(Bone.LeftArm), _figure.Turn(Bone.LeftArm)), 0.2f);
    }

    [Fact]
    public void A_text_asset_takes_precedence_over_the_path()
    {
        Begin(play: false);
        TimelineClip clip = AddClip("missing.bvh", 0);
        ((MotionClip)clip.asset).FileAsset = new TextAsset(File.ReadAllText(Bvh));
        clip.duration = 1;

        ShowAt(0);

        AssertPose(Retarget(new BvhSource(BvhDocument.Load(Bvh)), 0));
    }

    [Fact]
    public void A_recording_can_be_a_text_asset()
    {
        Begin(play: false);
        TimelineClip clip = AddClip("", 0);
        ((MotionClip)clip.asset).FileAsset = new TextAsset(File.ReadAllBytes(Recording));
        clip.duration = 1;
        string[] before = Directory.GetFiles(Application.temporaryCachePath);

        ShowAt(0.5);

        RecordingSource take = RecordingSource.Load(Recording);
        AssertPose(Retarget(take, 0.5 * take.FrameRate));
        Assert.Equal(before, Directory.GetFiles(Application.temporaryCachePath));
    }

    [Theory]
    [InlineData("", "no file")]
    [InlineData("missing.bvh", "missing.bvh")]
    public void A_file_that_cannot_be_used_is_named_and_changes_nothing(string file, string expected)
    {
        Begin(play: false);
        TimelineClip clip = AddClip(file, 0);
        Assert.Equal(5, clip.duration);

        ShowAt(0);

        Assert.Contains(expected, ((MotionClip)clip.asset).Problem, StringComparison.Ordinal);
        Assert.Contains(expected, Assert.Single(ConsoleLog.Entries).Message, StringComparison.Ordinal);
        Assert.False(_driver.IsPosed);
        ShowAt(1);
        Assert.Single(ConsoleLog.Entries);
    }

    [Fact]
    public void A_file_is_read_again_when_it_is_asked_for()
    {
        string copy = Path.Combine(Directory.CreateTempSubdirectory("takes").FullName, "take.bvh");
        try
        {
            Begin(play: false);
            var clip = (MotionClip)AddClip(copy, 0).asset;
            Assert.NotEqual(string.Empty, clip.Problem);

            File.Copy(Bvh, copy);
            Assert.NotEqual(string.Empty, clip.Problem);
            clip.Reload();
            Assert.Equal(string.Empty, clip.Problem);
            Assert.Equal(new BvhSource(BvhDocument.Load(Bvh)).FrameCount!.Value, clip.duration * BvhDocument.Load(Bvh).FrameRate, 1e-6);
        }
        finally
        {
            Directory.Delete(Path.GetDirectoryName(copy)!, recursive: true);
        }
    }

    [Fact]
    public void A_preview_restores_every_transform_of_the_figure()
    {
        Begin(play: false);
        var collected = new Collector();

        _track.GatherProperties(_director, collected);

        foreach (Transform node in _driver.FindRig(out _)!.Nodes)
        {
            Assert.Contains((node.gameObject, "m_LocalPosition"), collected.Properties);
            Assert.Contains((node.gameObject, "m_LocalRotation"), collected.Properties);
        }

        _director.SetGenericBinding(_track, null);
        _track.GatherProperties(_director, new Collector());
    }

    [Fact]
    public void A_preview_skips_a_bone_that_is_gone()
    {
        Begin(play: false);
        AddClip(Bvh, 0);
        ShowAt(0);
        int count = _driver.FindRig(out _)!.Nodes.Length;
        Object.DestroyImmediate(_figure[Bone.LeftHandIndex3].gameObject);
        var collected = new Collector();

        _track.GatherProperties(_director, collected);

        Assert.Equal(2 * (count - 1), collected.Properties.Count);
    }

    [Fact]
    public void A_frame_of_two_clips_allocates_nothing()
    {
        Begin(play: true);
        AddClip(Bvh, 0).duration = 1;
        AddClip(Recording, 0.2).duration = 1;
        ShowAt(0.5);
        var mixer = new MotionMixer();
        PlayableGraph graph = PlayableGraph.Create();
        var playable = ScriptPlayable<MotionMixer>.Create(graph, mixer, 2);
        int input = 0;
        foreach (TimelineClip clip in _track.GetClips())
        {
            playable.ConnectInput(input, ((MotionClip)clip.asset).CreatePlayable(graph, _director.gameObject), 0);
            playable.SetInputWeight(input++, 0.5f);
        }

        double time = 0;
        Allocations.AssertNone(() =>
        {
            playable.GetInput(0).SetTime(time += 0.001);
            mixer.ProcessFrame(playable, default, _driver);
        });
    }

    private void Begin(bool play)
    {
        if (!play)
        {
            Loop.Dispose();
            Loop = new PlayerLoop(play: false);
        }

        _figure = TestFigure.Build("Figure");
        _driver = _figure.Drive(null);
        _director = new GameObject("Director").AddComponent<PlayableDirector>();
        TimelineAsset timeline = ScriptableObject.CreateInstance<TimelineAsset>();
        _track = timeline.CreateTrack<MotionTrack>(null, "Motion");
        _director.playableAsset = timeline;
        _director.SetGenericBinding(_track, _driver);
    }

    private TimelineClip AddClip(string file, double start, MotionTrack? track = null)
    {
        TimelineClip clip = (track ?? _track).CreateClip<MotionClip>();
        ((MotionClip)clip.asset).File = file;
        (clip.start, clip.duration) = (start, ((MotionClip)clip.asset).duration);
        return clip;
    }

    private void ShowAt(double time)
    {
        _director.time = time;
        _director.Evaluate();
    }

    private RetargetedPose Retarget(MotionSource take, double frame)
    {
        var local = new BoneTransform[BoneHierarchy.BoneCount];
        take.GetPose((long)Math.Round(frame), local);
        var offsets = new Numerics.Vector3[BoneHierarchy.BoneCount];
        var endSites = new Numerics.Vector3[BoneHierarchy.BoneCount];
        take.GetBody(offsets, endSites);
        TargetRig rig = _driver.FindRig(out _)!.Target;
        var pose = new RetargetedPose(rig);
        Assert.True(new Retargeter(rig, new SkeletonBody(offsets, endSites, take.Variant)).TryRetarget(local, pose));
        return pose;
    }

    private static RetargetedPose Mix(RetargetedPose from, RetargetedPose to, float part)
    {
        for (int node = 0; node < to.LocalRotations.Length; node++)
            to.LocalRotations[node] = Numerics.Quaternion.Slerp(from.LocalRotations[node], to.LocalRotations[node], part);

        to.HipsLocalPosition = Numerics.Vector3.Lerp(from.HipsLocalPosition, to.HipsLocalPosition, part);
        return to;
    }

    private void AssertPose(RetargetedPose expected, float tolerance = 0.01f)
    {
        for (int node = 0; node < expected.Rig.Nodes.Length; node++)
        {
            Transform transform = Find(expected.Rig.Nodes[node].Name);
            Numerics.Quaternion difference = Numerics.Quaternion.Conjugate(expected.LocalRotations[node]) * transform.localRotation.ToNumerics();
            Assert.InRange(new Numerics.Vector3(difference.X, difference.Y, difference.Z).Length() * 2 * Mathf.Rad2Deg, 0, tolerance);
        }

        Vector3 hips = _figure[Bone.Hips].localPosition;
        Assert.Equal(0, (hips - expected.HipsLocalPosition.ToUnity()).magnitude, 1e-4f);
    }

    private Transform Find(string name) => Assert.Single(_figure.Root.GetComponentsInChildren<Transform>(true), item => item.name == name);

    private sealed class Collector : IPropertyCollector
    {
        public List<(GameObject Object, string Name)> Properties { get; } = [];

        public void AddFromName<T>(GameObject obj, string name)
            where T : Component => Properties.Add((obj, name));
    }
}
