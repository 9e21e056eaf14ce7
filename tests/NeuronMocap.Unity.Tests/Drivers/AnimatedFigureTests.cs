using NeuronMocap.Retargeting;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Drivers;

// A figure that follows its performer by half, and an Animator that writes in some frames only.
public sealed class AnimatedFigureTests : SourceFixture
{
    private static readonly Vector3 Lift = new(0, 0.2f, 0);

    private readonly TestFigure _figure;
    private HumanoidDriver _driver = null!;
    private Quaternion _arm;
    private Vector3 _hips;
    private int _writes;

    // Once there is a scene.
    public AnimatedFigureTests() => _figure = TestFigure.Build("Figure");

    [Fact]
    public void An_animation_of_every_second_frame_is_mixed_into_every_frame()
    {
        Animate();
        _figure.Animator.updateMode = AnimatorUpdateMode.AnimatePhysics;
        Loop.Frames(4, Time.fixedDeltaTime / 2);
        _writes = 0;
        _driver.Weight = 0.5f;
        for (int i = 0; i < 6; i++)
        {
            Loop.Frame(Time.fixedDeltaTime / 2);
            AssertHalfway();
        }

        Assert.Equal(3, _writes);
    }

    [Fact]
    public void The_last_animated_pose_stays_while_the_animator_is_culled()
    {
        Animate();
        MeshRenderer renderer = _figure.Root.AddComponent<MeshRenderer>();
        _figure.Animator.cullingMode = AnimatorCullingMode.CullUpdateTransforms;
        Loop.Frames(2);
        renderer.IsInView = false;
        _writes = 0;
        _driver.Weight = 0.5f;
        for (int i = 0; i < 3; i++)
        {
            Loop.Frame();
            AssertHalfway();
        }

        Assert.Equal(0, _writes);
    }

    [Fact]
    public void A_released_part_returns_to_the_animation()
    {
        Animate();
        _figure.Animator.updateMode = AnimatorUpdateMode.AnimatePhysics;

        // The next frame is one without a write.
        for (int before = _writes; _writes == before;)
            Loop.Frame(Time.fixedDeltaTime / 2);

        _driver.PartWeights.Set(BodyParts.LeftArm, 0);
        for (int i = 0; i < 4; i++)
        {
            Loop.Frame(Time.fixedDeltaTime / 2);
            Assert.Equal(80, Quaternion.Angle(_arm, _figure[Bone.LeftArm].localRotation), 0.1f);
        }
    }

    [Fact]
    public void The_pose_in_the_scene_is_no_animation()
    {
        _driver = _figure.Drive(AddSimulator(motion: SimulatedMotion.TPose));
        _driver.Weight = 0.5f;
        Loop.RunUntil(() => _driver.IsDriving);
        Assert.True(Quaternion.Angle(_figure.Turn(Bone.LeftArm), Quaternion.identity) < 0.1f, "The arm is not at rest.");
    }

    [Fact]
    public void Binding_again_returns_to_the_rest_pose()
    {
        Animate();
        _figure.Animator.updateMode = AnimatorUpdateMode.AnimatePhysics;
        Loop.Frames(4, Time.fixedDeltaTime / 2);
        _figure.Animator.Animating = null;
        Loop.Frame();
        _driver.Rebind();
        Assert.True(Quaternion.Angle(_arm, _figure[Bone.LeftArm].localRotation) < 0.1f, "The arm is not at rest.");
    }

    // The performer stands in the T-pose, and the animation turns an arm by 80 degrees and raises the hips.
    private void Animate()
    {
        _driver = _figure.Drive(AddSimulator(motion: SimulatedMotion.TPose));
        Loop.RunUntil(() => _driver.IsDriving);
        _arm = _figure[Bone.LeftArm].localRotation;
        _hips = _figure[Bone.Hips].localPosition;
        _figure.Animator.Animating = () =>
        {
            _writes++;
            _figure[Bone.LeftArm].localRotation = _arm * Quaternion.Euler(80, 0, 0);
            _figure[Bone.Hips].localPosition = _hips + Lift;
        };
    }

    private void AssertHalfway()
    {
        Assert.Equal(40, Quaternion.Angle(_arm, _figure[Bone.LeftArm].localRotation), 0.1f);
        Assert.True((_figure[Bone.Hips].localPosition - _hips - (Lift / 2)).magnitude < 0.001f, $"{_figure[Bone.Hips].localPosition}");
    }
}
