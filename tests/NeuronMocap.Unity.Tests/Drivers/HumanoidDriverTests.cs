using NeuronMocap.Motion;
using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Drivers;

public sealed class HumanoidDriverTests : SourceFixture
{
    private static readonly Bone[] SomeBones = [Bone.Hips, Bone.Spine2, Bone.Head, Bone.LeftArm, Bone.LeftForeArm, Bone.RightHand, Bone.LeftHandThumb2, Bone.RightFoot];

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Every_bone_of_an_unusual_rig_has_the_performers_world_rotation(int seed)
    {
        TestFigure figure = TestFigure.Build("Figure", seed);
        HumanoidDriver driver = figure.Drive(AddSimulator());
        Loop.RunUntil(() => driver.IsDriving);
        Loop.RunFor(0.3f);

        foreach (Bone bone in SomeBones)
            AssertNear(driver.Performer!.GetRotation(bone), figure.Turn(bone), bone);

        Assert.Equal(string.Empty, driver.Problem);
        Assert.Equal(string.Empty, driver.RestPoseNote);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void Hip_motion_is_scaled_by_leg_length()
    {
        TestFigure figure = TestFigure.Build("Figure", size: 0.5f);
        HumanoidDriver driver = figure.Drive(AddSimulator());
        Loop.RunUntil(() => driver.IsDriving);
        AssertNear(driver.Performer!.GetPosition(Bone.Hips) * 0.5f, InRoot(figure, Bone.Hips));

        driver.AutomaticScale = false;
        driver.Scale = 0;
        driver.HeightOffset = 0.25f;
        Loop.Frame();
        AssertNear(new Vector3(0, (SkeletonBody.GetDefault().GetOffset(Bone.Hips).Y * 0.005f) + 0.25f, 0), InRoot(figure, Bone.Hips));
        driver.RootMotion = RootMotion.InPlace;
        driver.AutomaticScale = true;
        Loop.Frame();
        Vector3 place = InRoot(figure, Bone.Hips);
        Assert.Equal(0, place.x, 0.001f);
        Assert.Equal(0, place.z, 0.001f);
    }

    [Fact]
    public void Transforms_match_the_retargeter()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(AddSimulator());
        Loop.RunUntil(() => driver.IsDriving);

        TargetRig rig = driver.TargetRig!;
        var pose = new RetargetedPose(rig);
        Assert.True(new Retargeter(rig, driver.Performer!.Body).TryRetarget(driver.Performer.LocalPose, pose));
        pose.UpdateWorld();
        foreach (Bone bone in SomeBones)
        {
            int node = IndexOf(rig, figure[bone].name);
            AssertNear(figure.Root.transform.rotation * pose.WorldRotations[node].ToUnity(), figure[bone].rotation, bone);
            AssertNear(figure.Root.transform.TransformPoint(pose.WorldPositions[node].ToUnity()), figure[bone].position);
        }
    }

    [Fact]
    public void Two_figures_follow_two_performers()
    {
        MocapSource source = AddSimulator(2);
        HumanoidDriver first = TestFigure.Build("A").Drive(null);
        TestFigure other = TestFigure.Build("B");
        HumanoidDriver second = other.Drive(source);
        second.PerformerChoice = PerformerChoice.ByName;
        second.PerformerName = "char01";
        Loop.RunUntil(() => first.IsDriving && second.IsDriving);

        Assert.Same(source, first.ActiveSource);
        Assert.Equal(0, first.Performer!.AvatarIndex);
        Assert.Equal(1, second.Performer!.AvatarIndex);
        AssertNear(second.Performer.GetRotation(Bone.Hips), other.Turn(Bone.Hips), Bone.Hips);
        Assert.Equal(1, SourceConnections.Count);
    }

    [Fact]
    public void Missing_settings_are_explained()
    {
        HumanoidDriver driver = new GameObject("Empty").AddComponent<HumanoidDriver>();
        Loop.Frame();
        Assert.Contains("No Animator", driver.Problem, StringComparison.Ordinal);

        TestFigure figure = TestFigure.Build("Figure");
        driver.Animator = figure.Animator;
        Loop.Frame();
        Assert.Contains("No mocap source", driver.Problem, StringComparison.Ordinal);

        MocapSource source = Add(source => source.Port = FreePort.Next());
        Loop.RunUntil(() => source.State == SourceState.Waiting);
        Loop.Frame();
        Assert.Equal(source.StatusMessage, driver.Problem);

        source.Kind = SourceKind.Simulator;
        driver.PerformerIndex = 3;
        WaitForPose(source);
        Loop.RunUntil(() => source.State == SourceState.Receiving);
        Loop.Frame();
        Assert.Equal("No performer 3. Change Performer Index to one of these: Char00 (0).", driver.Problem);
        driver.PerformerChoice = PerformerChoice.ByName;
        driver.PerformerName = "Anna";
        Loop.Frame();
        Assert.Equal("No performer is called \"Anna\". Change Performer Name to one of these: Char00 (0).", driver.Problem);

        driver.Source = source;
        source.enabled = false;
        Loop.Frame();
        Assert.Contains("disabled", driver.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_generic_avatar_is_refused_with_a_reason()
    {
        var root = new GameObject("Thing");
        Animator animator = root.AddComponent<Animator>();
        HumanoidDriver driver = root.AddComponent<HumanoidDriver>();
        Loop.Frame();
        Assert.Contains("no avatar", driver.Problem, StringComparison.Ordinal);
        animator.avatar = AvatarBuilder.BuildGenericAvatar(root, string.Empty);
        driver.Rebind();
        Loop.Frame();
        Assert.Contains("not Humanoid", driver.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void Enabling_again_restores_the_rest_pose()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(AddSimulator());
        for (int i = 0; i < 3; i++)
        {
            Loop.RunUntil(() => driver.IsDriving);
            Loop.RunFor(0.1f);
            foreach (Bone bone in SomeBones)
                AssertNear(driver.Performer!.GetRotation(bone), figure.Turn(bone), bone);

            driver.enabled = false;
            figure[Bone.LeftArm].localRotation = Quaternion.Euler(10 * i, 20, 30);
            driver.enabled = true;
        }
    }

    [Fact]
    public void A_part_without_weight_is_left_to_others_or_rests()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(AddSimulator());
        Loop.RunUntil(() => driver.IsDriving);
        Assert.True(Quaternion.Angle(figure.Turn(Bone.RightArm), Quaternion.identity) > 5);

        driver.PartWeights.Set(BodyParts.Arms | BodyParts.Fingers | BodyParts.Head, 0);
        Loop.Frame();
        AssertNear(figure.Turn(Bone.RightShoulder), figure.Turn(Bone.RightArm), Bone.RightArm);
        AssertNear(driver.Performer!.GetRotation(Bone.Spine2), figure.Turn(Bone.Spine2), Bone.Spine2);

        Quaternion headset = Quaternion.Euler(10, 20, 30);
        figure[Bone.Head].localRotation = headset;
        Loop.Frames(3);
        AssertNear(headset, figure[Bone.Head].localRotation, Bone.Head);
    }

    [Fact]
    public void Partial_weight_blends_with_the_rest_pose_without_drift()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(AddSimulator(motion: SimulatedMotion.TPose));
        Loop.RunUntil(() => driver.IsDriving);
        driver.RootMotion = RootMotion.InPlace;
        driver.HeightOffset = 0.4f;
        driver.Weight = 0.5f;
        Loop.Frame();
        float height = InRoot(figure, Bone.Hips).y;
        float rest = SkeletonBody.GetDefault().GetOffset(Bone.Hips).Y * 0.008f;
        Assert.Equal(rest + 0.2f, height, 0.001f);
        Loop.Frames(10);
        Assert.Equal(rest + 0.2f, InRoot(figure, Bone.Hips).y, 0.001f);
    }

    [Theory]
    [InlineData(IdleBehaviour.Hold)]
    [InlineData(IdleBehaviour.BlendToRest)]
    public void A_figure_without_data_holds_its_pose_or_rests(IdleBehaviour behaviour)
    {
        Broadcaster server = Serve(new SyntheticSource());
        MocapSource source = Add(server, static source => (source.IdleTimeout, source.LeaveTimeout) = (0.1f, 0.3f));
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(source);
        (driver.WhenIdle, driver.IdleBlendTime) = (behaviour, 0.2f);
        Loop.RunUntil(() => driver.IsDriving);
        server.Dispose();
        Loop.RunUntil(() => !driver.IsDriving && source.Performers.Count == 0);
        Quaternion last = figure[Bone.LeftArm].localRotation;
        Loop.RunFor(0.3f);

        Assert.NotEmpty(driver.Problem);
        Assert.True(Quaternion.Angle(figure.Turn(Bone.LeftArm), Quaternion.identity) > 5 == (behaviour == IdleBehaviour.Hold));
        if (behaviour == IdleBehaviour.Hold)
            AssertNear(last, figure[Bone.LeftArm].localRotation, Bone.LeftArm);
        else
            AssertNear(Quaternion.identity, figure.Turn(Bone.LeftArm), Bone.LeftArm);
    }

    [Fact]
    public void A_figure_rests_in_the_time_of_a_captured_film()
    {
        Broadcaster server = Serve(new SyntheticSource());
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(Add(server, static source => source.IdleTimeout = 0.1f));
        (driver.WhenIdle, driver.IdleBlendTime) = (IdleBehaviour.BlendToRest, 10);
        Loop.RunUntil(() => driver.IsDriving);
        server.Dispose();
        Loop.RunUntil(() => !driver.IsDriving);

        Time.captureDeltaTime = 2.5f;
        Loop.Frames(4, 0.001f);
        AssertNear(Quaternion.identity, figure.Turn(Bone.LeftArm), Bone.LeftArm);
    }

    [Fact]
    public void Standing_feet_do_not_slide()
    {
        TestFigure figure = TestFigure.Build("Figure", size: 0.7f);
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new SyntheticSource()], Calculation = CalculationSynthesizer.Write });
        HumanoidDriver driver = figure.Drive(Add(server));
        driver.FootPlanting = true;
        driver.HeightOffset = 0.02f;

        // Root motion is shorter than the legs' steps, so the feet slide without planting.
        (driver.AutomaticScale, driver.Scale) = (false, 0.6f);
        Loop.RunUntil(() => driver.IsDriving);

        // A contact without missed frames. On a busy machine, a whole step may fall between two frames, and motion and contacts no longer match.
        (Vector3 Foot, Vector3 Actor, double Time)? held = null;
        bool isWhole = false;
        double shown = 0;
        float farthest = 0;
        Loop.RunUntil(() =>
        {
            Performer performer = driver.Performer!;
            (Vector3 foot, Vector3 actor) = (InRoot(figure, Bone.RightFoot), performer.GetPosition(Bone.RightFoot));
            bool stands = performer.Contacts.Right;
            bool isMissed = performer.Time - shown > 0.1 || performer.PoseOrigin != PoseOrigin.Interpolated
                || (stands && held is { } before && (actor - before.Actor).magnitude > 0.01f);
            shown = performer.Time;
            isWhole = !isMissed && (isWhole || !stands);
            if (!isWhole || !stands)
            {
                (held, farthest) = (null, 0);
                return false;
            }

            held ??= (foot, actor, shown);
            farthest = Math.Max(farthest, new Vector3(foot.x - held.Value.Foot.x, 0, foot.z - held.Value.Foot.z).magnitude);
            return shown - held.Value.Time > 0.2;
        });
        Assert.InRange(farthest, 0, 0.005f);
    }

    [Fact]
    public void A_destroyed_figure_is_replaced_by_another()
    {
        TestFigure first = TestFigure.Build("First");
        HumanoidDriver driver = new GameObject("Driver").AddComponent<HumanoidDriver>();
        driver.Source = AddSimulator();
        driver.Animator = first.Animator;
        Loop.RunUntil(() => driver.IsDriving);

        Object.Destroy(first.Root);
        Loop.Frames(2);
        Assert.False(driver.IsDriving);
        Assert.Contains("No Animator", driver.Problem, StringComparison.Ordinal);

        TestFigure second = TestFigure.Build("Second");
        second.Root.transform.SetParent(driver.transform, false);
        Loop.RunUntil(() => driver.IsDriving);
        AssertNear(driver.Performer!.GetRotation(Bone.LeftArm), second.Turn(Bone.LeftArm), Bone.LeftArm);
    }

    [Fact]
    public void An_inactive_figure_waits_until_it_is_active()
    {
        TestFigure figure = TestFigure.Build("Figure");
        var holder = new GameObject("Holder");
        holder.SetActive(false);
        GameObject copy = Object.Instantiate(figure.Root, holder.transform);
        HumanoidDriver driver = new GameObject("Driver").AddComponent<HumanoidDriver>();
        driver.Source = AddSimulator();
        driver.Animator = copy.GetComponent<Animator>();
        Loop.RunUntil(() => driver.Problem.Contains("not active", StringComparison.Ordinal));

        holder.SetActive(true);
        Loop.RunUntil(() => driver.IsDriving);
    }

    [Fact]
    public void An_animation_close_to_the_motion_is_kept()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(Add(Serve(new ValuesSource(static (_, layout, values) =>
        {
            int arm = layout.GetRotationIndex(Bone.LeftArm);
            (values[arm], values[arm + 1], values[arm + 2]) = (20, 10, 40);
        }))));
        Loop.RunUntil(() => driver.IsDriving);
        Loop.RunFor(0.2f);
        Quaternion motion = figure[Bone.LeftArm].localRotation;

        // Closer than the difference that == of quaternions detects.
        figure.Animator.Animating = () => figure[Bone.LeftArm].localRotation = motion * Quaternion.Euler(0.05f, 0, 0);
        driver.Weight = 0.5f;
        for (int i = 0; i < 6; i++)
        {
            Loop.Frame();
            AssertNear(motion, figure[Bone.LeftArm].localRotation, Bone.LeftArm);
        }
    }

    private static Vector3 InRoot(TestFigure figure, Bone bone) => figure.Root.transform.InverseTransformPoint(figure[bone].position);

    private static int IndexOf(TargetRig rig, string name)
    {
        for (int i = 0; i < rig.Nodes.Length; i++)
        {
            if (rig.Nodes[i].Name == name)
                return i;
        }

        return -1;
    }

    private static void AssertNear(Vector3 expected, Vector3 actual) => Assert.True((expected - actual).magnitude < 1e-3f, $"{expected} {actual}");

    private static void AssertNear(Quaternion expected, Quaternion actual, Bone bone) =>
        Assert.True(Quaternion.Angle(expected, actual) < 0.1f, $"{bone}: {expected} {actual}, {Quaternion.Angle(expected, actual)} degrees");
}
