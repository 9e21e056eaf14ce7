using NeuronMocap.Bvh;
using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Unity.Timeline;
using UnityEngine.Playables;
using UnityEngine.Timeline;

namespace NeuronMocap.Unity.Tests.Timeline;

// Timeline and what else moves the figure.
public sealed partial class TimelineTests
{
    [Theory]
    [InlineData(true, true)]
    [InlineData(true, false)]
    [InlineData(false, true)]
    [InlineData(false, false)]
    public void A_track_in_a_gap_leaves_the_figure_to_another_track(bool isFirst, bool plays)
    {
        Begin(plays);
        MotionTrack other = ((TimelineAsset)_director.playableAsset!).CreateTrack<MotionTrack>(null, "Other");
        _director.SetGenericBinding(other, _driver);
        var take = new BvhSource(BvhDocument.Load(Bvh));
        AddClip(Bvh, 0, isFirst ? _track : other).duration = 0.3;
        AddClip(Bvh, 0.2, isFirst ? other : _track).duration = 0.3;
        ShowAt(0);
        FigureRig rig = _driver.FindRig(out _)!;

        // The first clip alone, then both, then the second one alone.
        foreach (double time in (double[])[0, 0.1, 0.25, 0.4, 0.45])
        {
            ShowAt(time);
            Assert.True(_driver.IsPosed);
            Assert.Same(rig, _driver.FindRig(out _));
        }

        ShowAt(2 / take.FrameRate);
        AssertPose(Retarget(take, 2));
        ShowAt(0.6);
        Assert.False(_driver.IsPosed);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_director_that_stops_leaves_the_figure_to_another_one(bool plays)
    {
        Begin(plays);
        var take = new BvhSource(BvhDocument.Load(Bvh));
        PlayableDirector other = new GameObject("Other").AddComponent<PlayableDirector>();
        TimelineAsset timeline = ScriptableObject.CreateInstance<TimelineAsset>();
        MotionTrack track = timeline.CreateTrack<MotionTrack>(null, "Motion");
        other.playableAsset = timeline;
        other.SetGenericBinding(track, _driver);
        AddClip(Bvh, 0);
        AddClip(Bvh, 0, track);
        ShowAt(0);
        other.time = 3 / take.FrameRate;
        other.Evaluate();

        _director.Stop();
        Assert.True(_driver.IsPosed);
        AssertPose(Retarget(take, 3));
        other.Stop();
        Assert.False(_driver.IsPosed);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_figure_whose_driver_is_removed_returns_to_its_pose_in_the_scene(bool evaluates)
    {
        Begin(play: false);
        AddClip(Bvh, 0);
        Transform[] nodes = _figure.Root.GetComponentsInChildren<Transform>();
        Quaternion[] scene = Array.ConvertAll(nodes, static node => node.localRotation);
        ShowAt(0.1);
        Assert.True(_driver.IsPosed);

        Object.DestroyImmediate(_driver);
        if (evaluates)
            ShowAt(0.2);
        else
            _director.Stop();

        for (int i = 0; i < nodes.Length; i++)
            Assert.Equal(0, Quaternion.Angle(scene[i], nodes[i].localRotation), 0.01f);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(0.5f)]
    public void An_animator_that_writes_after_timeline_does_not_replace_the_clip(float weight)
    {
        Begin(play: true);
        AddClip(Bvh, 0);
        _driver.Weight = weight;
        var take = new BvhSource(BvhDocument.Load(Bvh));
        ShowAt(0);
        RetargetedPose shown = Retarget(take, 0);
        _figure.Animator.Animating = () => Show(Animated());

        foreach (int frame in (int[])[3, 4])
        {
            ShowAt(frame / take.FrameRate);
            Loop.Frame();
            AssertPose(Mix(Animated(), Retarget(take, frame), weight), 0.05f);
        }

        RetargetedPose Animated()
        {
            var pose = new RetargetedPose(shown.Rig);
            for (int node = 0; node < pose.LocalRotations.Length; node++)
            {
                if (shown.IsDriven(node))
                    pose.LocalRotations[node] *= Quaternion.Euler(0, 30, 10).ToNumerics();
            }

            pose.HipsLocalPosition += new System.Numerics.Vector3(0.1f, 0.2f, 0);
            return pose;
        }
    }

    [Fact]
    public void A_prop_with_a_body_stays_in_the_hand_that_timeline_moves()
    {
        Begin(play: true);
        _driver.Source = AddSimulator();
        FigureColliders.Add(_driver);
        _driver.DriveTime = DriveTime.Physics;
        HandProp prop = new GameObject("Sword").AddComponent<HandProp>();
        prop.gameObject.AddComponent<Rigidbody>().isKinematic = true;
        prop.Driver = _driver;
        Loop.RunUntil(() => _driver.IsDriving);
        AddClip(Bvh, 0);

        foreach (double time in (double[])[0, 0.4])
        {
            ShowAt(time);
            Loop.Frames(3, Time.fixedDeltaTime);
            Assert.Equal(0, (_figure[Bone.RightHand].position - prop.transform.position).magnitude, 0.001f);
        }
    }

    // Time need not pass in edit mode.
    [Fact]
    public void A_figure_that_was_mended_is_shown_at_once_in_edit_mode()
    {
        Begin(play: false);
        AddClip(Bvh, 0);
        Avatar avatar = _figure.Animator.avatar!;
        _figure.Animator.avatar = null;
        ShowAt(0);
        Assert.False(_driver.IsPosed);
        Assert.NotEqual(string.Empty, _driver.Problem);

        _figure.Animator.avatar = avatar;
        ShowAt(0);
        Assert.True(_driver.IsPosed);
    }

    private void Show(RetargetedPose pose)
    {
        for (int node = 0; node < pose.Rig.Nodes.Length; node++)
            Find(pose.Rig.Nodes[node].Name).localRotation = pose.LocalRotations[node].ToUnity();

        _figure[Bone.Hips].localPosition = pose.HipsLocalPosition.ToUnity();
    }
}
