using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Figures;

public sealed class FollowCameraTests : IDisposable
{
    private readonly PlayerLoop _loop = new();
    private readonly FollowCamera _follow = new GameObject("Eye").AddComponent<FollowCamera>();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Without_a_target_the_object_stays()
    {
        _follow.transform.position = new Vector3(1, 2, 3);
        _loop.Frames(3);
        Assert.Equal(new Vector3(1, 2, 3), _follow.transform.position);
    }

    [Fact]
    public void It_is_at_its_viewpoint_in_the_first_frame_and_looks_at_the_target()
    {
        _follow.Target = new GameObject("Target").transform;
        _follow.Target.position = new Vector3(4, 1, 2);
        _loop.Frame();
        AssertLooksAt(_follow.Target.position);
    }

    [Fact]
    public void A_time_of_0_follows_at_once()
    {
        _follow.Target = new GameObject("Target").transform;
        _follow.FollowTime = 0;
        for (int i = 0; i < 5; i++)
        {
            _follow.Target.position = new Vector3(i * 3, 1, -i);
            _loop.Frame();
            AssertLooksAt(_follow.Target.position);
        }
    }

    [Fact]
    public void The_distance_to_a_target_that_moved_falls_to_a_third_in_the_follow_time()
    {
        _follow.Target = new GameObject("Target").transform;
        _follow.FollowTime = 0.5f;
        _loop.Frame();
        _follow.Target.position = new Vector3(9, 0, 0);
        _loop.Frames(30);
        float distance = (_follow.transform.position - (_follow.Target.position + _follow.Viewpoint)).magnitude;
        Assert.InRange(distance, 9 * 0.33f, 9 * 0.4f);
    }

    [Fact]
    public void A_captured_film_does_not_depend_on_the_time_that_frames_take()
    {
        _follow.Target = new GameObject("Target").transform;
        _follow.FollowTime = 0.5f;
        _loop.Frame();
        Time.captureFramerate = 20;
        _follow.Target.position = new Vector3(9, 0, 0);
        for (int i = 0; i < 10; i++)
            _loop.Frame(i % 2 == 0 ? 0.001f : 0.4f);

        float distance = (_follow.transform.position - (_follow.Target.position + _follow.Viewpoint)).magnitude;
        Assert.Equal(9 / MathF.E, distance, 0.05f);
    }

    [Fact]
    public void The_hips_of_a_Humanoid_character_are_followed()
    {
        TestFigure figure = TestFigure.Build("Ann");
        _follow.Target = figure.Animator.transform;
        _follow.FollowTime = 0;
        Transform hips = figure.Animator.GetBoneTransform(HumanBodyBones.Hips)!;
        hips.position = new Vector3(2, 0.9f, 5);
        _loop.Frame();
        AssertLooksAt(hips.position);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void The_hips_of_a_driven_figure_are_followed_from_the_driver_from_above_and_from_below(bool isGeneric)
    {
        var stage = new GameObject("Stage");
        Transform hips;
        Transform head;
        FigureDriver driver;
        if (isGeneric)
        {
            GameObject rig = GenericRig.Build("", out Dictionary<Bone, Transform> bones);
            (hips, head) = (bones[Bone.Hips], bones[Bone.Head]);
            driver = rig.AddComponent<GenericRigDriver>();
        }
        else
        {
            TestFigure figure = TestFigure.Build("Ann");
            (hips, head) = (figure[Bone.Hips], figure[Bone.Head]);
            driver = figure.Drive(null);
        }

        driver.transform.SetParent(stage.transform, false);
        _follow.FollowTime = 0;
        foreach (Transform target in (Transform[])[driver.transform, stage.transform, head])
        {
            _follow.Target = target;
            hips.position += new Vector3(2, 0.1f, 5);
            _loop.Frame();
            AssertLooksAt(hips.position);
        }
    }

    [Fact]
    public void A_figure_that_appears_below_the_target_is_found()
    {
        _follow.FollowTime = 0;
        _follow.Target = new GameObject("Stage").transform;
        _loop.Frame();
        AssertLooksAt(_follow.Target.position);

        TestFigure figure = TestFigure.Build("Ann");
        figure.Drive(null).transform.SetParent(_follow.Target, false);
        _loop.Frame(1.1f);
        AssertLooksAt(figure[Bone.Hips].position);

        Object.DestroyImmediate(figure.Root);
        _loop.Frame();
        AssertLooksAt(_follow.Target.position);
    }

    [Fact]
    public void Another_target_is_followed_by_its_own_kind()
    {
        _follow.FollowTime = 0;
        FigureBuilder builder = new GameObject("Figure").AddComponent<FigureBuilder>();
        Transform box = new GameObject("Box").transform;
        box.position = new Vector3(-3, 0, 0);
        _follow.Target = builder.transform;
        _loop.Frames(2);
        AssertLooksAt(builder.Figure!.GetBone(Bone.Hips).position);

        _follow.Target = box;
        _loop.Frame();
        AssertLooksAt(box.position);
    }

    [Fact]
    public void Following_allocates_nothing()
    {
        _follow.Target = TestFigure.Build("Ann").Animator.transform;
        _loop.Frames(3);
        FrameAllocations.AssertNone(_loop);
    }

    private void AssertLooksAt(Vector3 focus)
    {
        Transform eye = _follow.transform;
        Assert.True((eye.position - (focus + _follow.Viewpoint)).magnitude < 1e-3f, $"{eye.position}");
        Assert.True(Vector3.Angle(eye.forward, focus - eye.position) < 0.1f);
    }
}
