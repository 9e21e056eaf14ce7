using System.Collections;
using System.Diagnostics;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;
using NeuronMocap.Unity.Tests.StandIn;
using Numerics = System.Numerics;

namespace NeuronMocap.Unity.Tests.Drivers;

public sealed class PhysicsDriverTests : SourceFixture
{
    private const float Speed = 0.5f;

    [Fact]
    public void A_figure_with_colliders_takes_the_performers_pose()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = DriveWithPhysics(figure, new MovingActor(0));
        Loop.RunUntil(() => driver.IsDriving);
        Loop.RunFor(0.3f);

        foreach (Bone bone in (Bone[])[Bone.Hips, Bone.Spine2, Bone.Head, Bone.LeftForeArm, Bone.RightHand, Bone.LeftHandIndex2, Bone.LeftFoot])
            Assert.Equal(0, Quaternion.Angle(driver.Performer!.GetRotation(bone), figure.Turn(bone)), 0.5f);

        Assert.Empty(ConsoleLog.Entries);
    }

    // Each step has its own pose. Otherwise, with three steps for each rendered frame, two of three speeds would be 0.
    [Theory]
    [InlineData(0.001)]
    [InlineData(0.06)]
    public void Bodies_have_the_speed_of_the_performer_in_every_step(double secondsPerFrame)
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = DriveWithPhysics(figure, new MovingActor(Speed));
        driver.Source!.Delay = 100;
        Rigidbody hips = figure[Bone.Hips].GetComponent<Rigidbody>();
        var speeds = new List<float>();
        new GameObject("Probe").AddComponent<StepProbe>().OnStep = () => speeds.Add(hips.velocity.magnitude);
        Loop.RunUntil(() => driver.IsDriving);
        RunSlowly(secondsPerFrame, () => speeds.Count > 20);

        bool isInTime = false;
        for (int attempt = 0; attempt < 20 && !(isInTime && Moves(speeds)); attempt++)
        {
            speeds.Clear();
            isInTime = RunSlowly(secondsPerFrame, () => speeds.Count > 60);
        }

        AssertSpeed(speeds);
    }

    [Theory]
    [InlineData(RootMotionTarget.RootTransform)]
    [InlineData(RootMotionTarget.CharacterController)]
    public void Bodies_have_the_speed_of_the_performer_while_the_root_walks(RootMotionTarget target)
    {
        TestFigure figure = TestFigure.Build("Figure");
        figure.Root.AddComponent<CharacterController>();
        CharacterController.Floor = -0.5f;
        HumanoidDriver driver = DriveWithPhysics(figure, new MovingActor(Speed));
        driver.RootMotionTarget = target;
        driver.Source!.Delay = 100;
        Rigidbody[] bodies = [.. ((Bone[])[Bone.Hips, Bone.Head, Bone.LeftHand]).Select(bone => figure[bone].GetComponent<Rigidbody>())];
        List<float>[] speeds = [.. bodies.Select(static _ => new List<float>())];
        new GameObject("Probe").AddComponent<StepProbe>().OnStep = () =>
        {
            for (int i = 0; i < bodies.Length; i++)
                speeds[i].Add(bodies[i].velocity.magnitude);
        };
        Loop.RunUntil(() => driver.IsDriving);
        RunSlowly(0.001, () => speeds[0].Count > 20);
        Vector3 start = default;
        var time = new Stopwatch();

        bool isInTime = false;
        for (int attempt = 0; attempt < 20 && !(isInTime && speeds.All(Moves) && Way() > 0.6f * Speed); attempt++)
        {
            Array.ForEach(speeds, static list => list.Clear());
            start = figure.Root.transform.position;
            time.Restart();
            isInTime = RunSlowly(0.001, () => speeds[0].Count > 60);
        }

        // The performer walks in real time, and the game takes fewer steps in it if the computer is busy.
        Assert.InRange(Way(), 0.6f * Speed, 2.4f * Speed * ((float)time.Elapsed.TotalSeconds + 0.5f));
        Assert.All(speeds, AssertSpeed);

        float Way() => (figure.Root.transform.position - start).magnitude;
    }

    [Fact]
    public void Leaving_physics_gives_all_bones_back_to_the_transforms()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = DriveWithPhysics(figure, new MovingActor(0));
        Loop.RunUntil(() => driver.IsDriving);
        AvatarStream stream = driver.Performer!.Stream;
        Loop.RunFor(0.1f);
        Assert.Equal(2, BufferCount(stream));

        driver.DriveTime = DriveTime.LateUpdate;
        Loop.Frame();
        Assert.Equal(0, Quaternion.Angle(driver.Performer!.GetRotation(Bone.LeftHand), figure.Turn(Bone.LeftHand)), 0.2f);
        Assert.Equal(1, BufferCount(stream));

        driver.DriveTime = DriveTime.Physics;
        Loop.RunFor(0.1f);
        Assert.Equal(2, BufferCount(stream));
        driver.enabled = false;
        Assert.Equal(1, BufferCount(stream));
    }

    [Theory]
    [InlineData(RootMotionTarget.Hips)]
    [InlineData(RootMotionTarget.CharacterController)]
    public void Frames_with_steps_allocate_nothing(RootMotionTarget target)
    {
        TestFigure figure = TestFigure.Build("Figure");
        figure.Root.AddComponent<CharacterController>();
        HumanoidDriver driver = DriveWithPhysics(figure, new MovingActor(Speed));
        (driver.Smoothing, driver.FootPlanting, driver.RootMotionTarget) = (true, true, target);
        AddProp(driver, hasBody: true);
        Loop.RunUntil(() => driver.IsDriving);
        Loop.RunFor(0.2f);

        Assert.Equal(0, Infrastructure.Measure.BytesPerFrame(Loop, driver, "FixedUpdate", "Update"));
    }

    [Fact]
    public void A_prop_with_a_body_is_in_the_hand_after_the_same_step()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = DriveWithPhysics(figure, new MovingActor(Speed));
        HandProp prop = AddProp(driver, hasBody: true);
        Loop.RunUntil(() => driver.IsDriving);
        Loop.RunFor(0.3f);

        AssertHeld(prop, figure[Bone.RightHand]);
        RunUntilMoved(prop.GetComponent<Rigidbody>());
        AssertHeld(prop, figure[Bone.RightHand]);
    }

    // Its transform goes with the hand, which gives no velocity.
    [Theory]
    [InlineData(DriveTime.Physics)]
    [InlineData(DriveTime.LateUpdate)]
    public void A_prop_below_the_hand_goes_its_way_through_physics(DriveTime time)
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = DriveWithPhysics(figure, new MovingActor(Speed));
        driver.DriveTime = time;
        driver.Source!.Delay = 100;
        HandProp prop = AddProp(driver, hasBody: true);
        prop.transform.SetParent(figure[Bone.RightHand], false);
        Rigidbody body = prop.GetComponent<Rigidbody>();
        Loop.RunUntil(() => driver.IsDriving);
        Loop.RunFor(0.3f);

        // The velocity of each step is that of its way, except after a stall.
        var errors = new List<float>();
        float whole = 0;
        new GameObject("Probe").AddComponent<StepProbe>().StartCoroutine(Watch());
        Loop.RunUntil(() => whole > 0.2f);

        errors.Sort();
        Assert.Equal(0, errors[errors.Count * 9 / 10], 0.01f);

        IEnumerator Watch()
        {
            Vector3 place = body.position;
            while (true)
            {
                yield return new WaitForFixedUpdate();
                Vector3 way = body.position - place;
                place = body.position;
                whole += way.magnitude;
                errors.Add((way - (body.velocity * Time.fixedDeltaTime)).magnitude);
            }
        }
    }

    [Fact]
    public void A_prop_whose_body_is_not_kinematic_is_kinematic_while_it_is_held()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = DriveWithPhysics(figure, new MovingActor(Speed));
        HandProp prop = AddProp(driver, hasBody: true);
        Rigidbody body = prop.GetComponent<Rigidbody>();
        body.isKinematic = false;
        Loop.RunUntil(() => driver.IsDriving);
        Loop.RunFor(0.3f);
        AssertHeld(prop, figure[Bone.RightHand]);
        Assert.True(body.isKinematic);
        RunUntilMoved(body);

        prop.enabled = false;
        Assert.False(body.isKinematic);
        prop.enabled = true;
        Loop.RunFor(0.1f);
        Assert.True(body.isKinematic);
        Object.DestroyImmediate(driver);
        Loop.RunFor(0.1f);
        Assert.False(body.isKinematic);

        // A body that is kinematic by itself stays so.
        body.isKinematic = true;
        prop.enabled = false;
        Assert.True(body.isKinematic);
    }

    [Fact]
    public void A_bone_whose_body_is_not_kinematic_is_reported()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = DriveWithPhysics(figure, new MovingActor(0));
        Rigidbody arm = figure[Bone.LeftForeArm].GetComponent<Rigidbody>();
        arm.isKinematic = false;
        Loop.RunUntil(() => driver.IsDriving);
        Assert.Contains(arm.name, driver.Problem);
        Assert.Contains("kinematic", driver.Problem);

        arm.isKinematic = true;
        Loop.RunFor(0.1f);
        Assert.Empty(driver.Problem);
    }

    [Fact]
    public void A_prop_without_a_body_follows_any_driver_in_the_same_frame()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(AddSimulator());
        HandProp prop = AddProp(driver, hasBody: false);
        Loop.RunUntil(() => driver.IsDriving);
        Loop.Frame();

        AssertHeld(prop, figure[Bone.RightHand]);
    }

    [Fact]
    public void A_prop_keeps_the_place_that_it_was_given()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HandProp prop = new GameObject("Prop").AddComponent<HandProp>();
        Assert.False(prop.HoldAsPlaced());
        prop.Driver = figure.Drive(null);
        prop.transform.SetPositionAndRotation(figure[Bone.RightHand].position + Vector3.up, Quaternion.Euler(10, 20, 30));

        Assert.True(prop.HoldAsPlaced());
        (Vector3 position, Quaternion rotation) = (prop.transform.position, prop.transform.rotation);
        Loop.Frame();

        Assert.Equal(0, (position - prop.transform.position).magnitude, 1e-4f);
        Assert.Equal(0, Quaternion.Angle(rotation, prop.transform.rotation), 0.1f);
        Assert.Equal(1, prop.PositionOffset.magnitude, 1e-4f);
    }

    // Renders frames of at least this duration, in real time. Returns false if a frame was so long that the game shortens it. Then each step moves further.
    private bool RunSlowly(double secondsPerFrame, Func<bool> condition)
    {
        var watch = Stopwatch.StartNew();
        bool isInTime = true;
        double last = 0;
        while (!condition())
        {
            SpinWait.SpinUntil(() => watch.Elapsed.TotalSeconds - last >= secondsPerFrame);
            double now = watch.Elapsed.TotalSeconds;
            isInTime &= now - last < Time.maximumDeltaTime;
            Loop.Frame((float)(now - last));
            last = now;
        }

        return isInTime;
    }

    // Bodies stand still in steps that fall into a gap of the stream, because its server waits for the processor.
    private static bool Moves(List<float> steps) => steps.Count(static speed => speed < 0.1f * Speed) < steps.Count / 4;

    // The body moves in most steps, and its middle speed is that of the performer. The figure's legs have 0.8 of the length, and its root is scaled by 1.5.
    private static void AssertSpeed(List<float> steps)
    {
        Assert.True(Moves(steps), string.Join(' ', steps));
        Assert.InRange(steps.Order().ElementAt(steps.Count / 2), 0.6f * Speed, 2.4f * Speed);
    }

    // A single step may fall into a gap too.
    private void RunUntilMoved(Rigidbody body) => Loop.RunUntil(() => body.velocity.magnitude is > 0.1f * Speed and < 10 * Speed);

    private static void AssertHeld(HandProp prop, Transform hand)
    {
        Vector3 place = hand.position + (hand.rotation * prop.PositionOffset);
        Assert.Equal(0, (place - prop.transform.position).magnitude, 0.001f);
        Assert.Equal(0, Quaternion.Angle(hand.rotation * Quaternion.Euler(prop.RotationOffset), prop.transform.rotation), 0.1f);
    }

    private static HandProp AddProp(FigureDriver driver, bool hasBody)
    {
        HandProp prop = new GameObject("Sword").AddComponent<HandProp>();
        (prop.Driver, prop.PositionOffset, prop.RotationOffset) = (driver, new Vector3(0, 0.1f, 0.02f), new Vector3(0, 90, 0));
        if (hasBody)
            prop.gameObject.AddComponent<Rigidbody>().isKinematic = true;

        return prop;
    }

    private static int BufferCount(AvatarStream stream) => ((Array)Infrastructure.Measure.Field(stream, "_buffers")!).Length;

    private HumanoidDriver DriveWithPhysics(TestFigure figure, MotionSource actor)
    {
        HumanoidDriver driver = figure.Drive(Add(Serve(actor)));
        FigureColliders.Add(driver);
        driver.DriveTime = DriveTime.Physics;
        return driver;
    }

    // Bent, and moving forward at a steady speed, in metres per second.
    private sealed class MovingActor(float speed) : MotionSource
    {
        public override double FrameRate => 100;

        public override long? FrameCount => null;

        public override bool HasDisplacement => true;

        public override void GetPose(long frame, Span<BoneTransform> pose)
        {
            SkeletonBody.GetDefault().CopyRestPose(pose);
            for (int bone = 1; bone < BoneHierarchy.BoneCount; bone++)
                pose[bone] = pose[bone] with { Rotation = Numerics.Quaternion.CreateFromAxisAngle(Numerics.Vector3.UnitX, 0.1f) };

            pose[0] = pose[0] with { Position = pose[0].Position + new Numerics.Vector3(0, 0, speed * frame) };
        }

        public override FootContacts GetFootContacts(long frame) => new(false, false);
    }
}
