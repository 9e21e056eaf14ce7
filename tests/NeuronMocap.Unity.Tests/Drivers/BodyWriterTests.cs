using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using Numerics = System.Numerics;

namespace NeuronMocap.Unity.Tests.Drivers;

// Writes poses step by step, without a source.
public sealed class BodyWriterTests : IDisposable
{
    private const float Step = 0.02f;

    private readonly PlayerLoop _loop = new();
    private readonly TestFigure _figure = TestFigure.Build("Figure");
    private readonly FigureRig _rig;
    private readonly RetargetedPose _pose;
    private readonly Retargeter _retargeter;

    public BodyWriterTests()
    {
        _rig = _figure.Drive(null).FindRig(out _)!;
        _pose = new RetargetedPose(_rig.Target);
        _retargeter = new Retargeter(_rig.Target, SkeletonBody.GetDefault());
    }

    public void Dispose() => _loop.Dispose();

    public static TheoryData<Bone[]> Bodies => new(
        [Bone.Hips, Bone.Spine, Bone.Spine1, Bone.Spine2, Bone.LeftShoulder, Bone.LeftArm, Bone.LeftForeArm, Bone.LeftHand, Bone.RightUpLeg, Bone.RightLeg],
        [Bone.LeftHand, Bone.RightFoot],
        [Bone.Spine, Bone.LeftForeArm, Bone.LeftHandIndex2],
        [Bone.Hips, Bone.Head]);

    [Theory, MemberData(nameof(Bodies))]
    public void Bodies_reach_the_pose_and_have_the_velocity_of_the_motion(Bone[] bones)
    {
        Rigidbody[] bodies = [.. bones.Select(AddBody)];
        Vector3[] before = [];
        Quaternion[] turnBefore = [];
        for (int step = 0; step < 5; step++)
        {
            SetPose(0.01f * step);
            _rig.Bodies.Write(_pose, 1);
            _loop.Frame(Step);
            AssertFigureHasThePose();
            if (step > 1)
            {
                for (int i = 0; i < bodies.Length; i++)
                {
                    Vector3 expected = (bodies[i].transform.position - before[i]) / Step;
                    Assert.Equal(0, (expected - bodies[i].velocity).magnitude, 0.01f);
                    Assert.InRange(bodies[i].velocity.magnitude, 0.01f, 20);
                    float turn = Quaternion.Angle(turnBefore[i], bodies[i].transform.rotation) * Mathf.Deg2Rad / Step;
                    Assert.Equal(turn, bodies[i].angularVelocity.magnitude, 0.05f);
                }
            }

            before = Array.ConvertAll(bodies, static body => body.transform.position);
            turnBefore = Array.ConvertAll(bodies, static body => body.transform.rotation);
        }

        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void The_first_pose_and_a_far_place_are_jumps()
    {
        Rigidbody body = AddBody(Bone.Hips);
        SetPose(0);
        _rig.Bodies.Write(_pose, 1);
        _loop.Frame(Step);
        Assert.Equal(Vector3.zero, body.velocity);

        _pose.HipsLocalPosition += new Numerics.Vector3(0, 0, 100);
        _rig.Bodies.Write(_pose, 1);
        _loop.Frame(Step);
        Assert.Equal(Vector3.zero, body.velocity);
        AssertFigureHasThePose();
    }

    // Such as a platform. Physics notices a changed transform only in its step.
    [Fact]
    public void A_root_that_a_script_moves_takes_bodies_along()
    {
        Rigidbody body = AddBody(Bone.Hips);
        for (int step = 0; step < 4; step++)
        {
            SetPose(0.01f * step);
            _figure.Root.transform.position += new Vector3(2, 0, 0);
            _rig.Bodies.Write(_pose, 1);
            _loop.Frame(Step);
            AssertFigureHasThePose();
        }

        Assert.InRange(body.velocity.magnitude, 0.01f, 20);
    }

    [Fact]
    public void A_body_with_half_the_weight_is_halfway_from_rest()
    {
        AddBody(Bone.LeftForeArm);
        SetPose(0.5f);
        _rig.Bodies.Write(_pose, 0.5f);
        _loop.Frame(Step);

        int node = _rig.Target.GetNode(HumanoidBone.LeftLowerArm);
        Quaternion rest = _rig.Target.Nodes[node].Rotation.ToUnity();
        Quaternion whole = _pose.LocalRotations[node].ToUnity();
        Assert.InRange(Quaternion.Angle(rest, whole), 5, 180);
        Assert.Equal(0, Quaternion.Angle(Quaternion.Slerp(rest, whole, 0.5f), _figure[Bone.LeftForeArm].localRotation), 0.1f);
    }

    [Fact]
    public void Bodies_that_are_not_kinematic_or_come_and_go_are_moved_as_transforms()
    {
        Rigidbody body = AddBody(Bone.LeftHand);
        body.isKinematic = false;
        SetPose(0.2f);
        _rig.Bodies.Write(_pose, 1);
        AssertFigureHasThePose();

        body.isKinematic = true;
        SetPose(0.3f);
        _rig.Bodies.Write(_pose, 1);
        _loop.Frame(Step);
        Object.DestroyImmediate(body);
        SetPose(0.4f);
        _rig.Bodies.Write(_pose, 1);
        AssertFigureHasThePose();
    }

    // The pose of the body is not that of an Animator.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_bone_without_its_body_mixes_the_motion_with_the_rest_pose(bool ends)
    {
        Rigidbody body = AddBody(Bone.LeftForeArm);
        for (int step = 1; step <= 3; step++)
        {
            SetPose(0.3f * step);
            _rig.Bodies.Write(_pose, 1);
            _loop.Frame(Step);
        }

        Object.DestroyImmediate(body);
        SetPose(0.5f);
        if (ends)
        {
            _rig.Bodies.End();
            _rig.Writer.Write(_pose, 0.5f);
        }
        else
        {
            _rig.Bodies.Write(_pose, 0.5f);
        }

        int node = _rig.Target.GetNode(HumanoidBone.LeftLowerArm);
        Quaternion rest = _rig.Target.Nodes[node].Rotation.ToUnity();
        Quaternion half = Quaternion.Slerp(rest, _pose.LocalRotations[node].ToUnity(), 0.5f);
        Assert.Equal(0, Quaternion.Angle(half, _figure[Bone.LeftForeArm].localRotation), 0.1f);
    }

    [Fact]
    public void Restoring_returns_bodies_to_rest_and_ending_gives_them_back()
    {
        AddBody(Bone.LeftHand);
        AddBody(Bone.Hips);
        SetPose(0.3f);
        _rig.Bodies.Write(_pose, 1);
        _loop.Frame(Step);

        _rig.Bodies.End();
        SetPose(0.4f);
        _rig.Writer.Write(_pose, 1);
        AssertFigureHasThePose();

        _rig.Bodies.Write(_pose, 1);
        _rig.Bodies.Restore();
        int node = _rig.Target.GetNode(HumanoidBone.LeftHand);
        Assert.Equal(0, Quaternion.Angle(_rig.Target.Nodes[node].Rotation.ToUnity(), _figure[Bone.LeftHand].localRotation), 0.1f);
    }

    [Fact]
    public void A_step_allocates_nothing()
    {
        AddBody(Bone.Hips);
        AddBody(Bone.LeftHand);
        float angle = 0;
        Allocations.AssertNone(() =>
        {
            SetPose(angle += 0.001f);
            _rig.Bodies.Write(_pose, 0.9f);
            PhysicsStep.Run(Step);
        });
    }

    private Rigidbody AddBody(Bone bone)
    {
        Rigidbody body = _figure[bone].gameObject.AddComponent<Rigidbody>();
        body.isKinematic = true;
        return body;
    }

    // Turns every bone about an axis of its own, and moves the hips.
    private void SetPose(float angle)
    {
        Span<BoneTransform> local = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        SkeletonBody.GetDefault().CopyRestPose(local);
        for (int bone = 0; bone < local.Length; bone++)
        {
            var axis = Numerics.Vector3.Normalize(new Numerics.Vector3(1, bone % 3, bone % 5));
            local[bone] = local[bone] with { Rotation = Numerics.Quaternion.CreateFromAxisAngle(axis, angle) };
        }

        local[0] = local[0] with { Position = local[0].Position + new Numerics.Vector3(20 * angle, 0, 0) };
        Assert.True(_retargeter.TryRetarget(local, _pose));
    }

    private void AssertFigureHasThePose()
    {
        _pose.UpdateWorld();
        Transform root = _figure.Root.transform;
        for (int node = 0; node < _rig.Nodes.Length; node++)
        {
            Assert.Equal(0, (root.TransformPoint(_pose.WorldPositions[node].ToUnity()) - _rig.Nodes[node].position).magnitude, 0.001f);
            Assert.Equal(0, Quaternion.Angle(root.rotation * _pose.WorldRotations[node].ToUnity(), _rig.Nodes[node].rotation), 0.1f);
        }
    }
}
