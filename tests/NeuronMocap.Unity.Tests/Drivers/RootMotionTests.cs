using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Drivers;

/// <summary>Root motion that moves a root transform or a character controller.</summary>
public sealed class RootMotionTests : SourceFixture
{
    private static readonly Bone[] SomeBones = [Bone.Hips, Bone.Head, Bone.LeftHand, Bone.RightFoot];

    private readonly PlacedActor _actor = new();

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void The_root_goes_where_the_hips_would_go(bool isMirroredAndRecentred)
    {
        MocapSource source = Show();
        if (isMirroredAndRecentred)
        {
            source.Stage.Mirror = true;
            WaitForPose(source);
            Put(source, new Vector3(2, 0, 1), 40);
            source.Recenter();
            Loop.Frame();
        }

        TestFigure still = TestFigure.Build("Still");
        TestFigure moving = TestFigure.Build("Moving");
        HumanoidDriver[] drivers = [still.Drive(source), moving.Drive(source)];
        drivers[1].RootMotionTarget = RootMotionTarget.RootTransform;
        Loop.RunUntil(() => drivers.All(static driver => driver.IsDriving));
        Vector3 start = moving.Root.transform.position;
        Assert.Equal(still.Root.transform.position, start);

        foreach ((Vector3 position, float heading) in ((Vector3, float)[])[(new(1, 0, 2), 30), (new(-0.5f, 0.1f, 1), 160), (new(0.3f, -0.2f, -2), -70)])
        {
            Put(source, position, heading);
            Assert.True((still.Root.transform.position - start).magnitude < 1e-6f);
            Assert.True((moving.Root.transform.position - start).magnitude > 0.5f);
            Assert.Equal(start.y, moving.Root.transform.position.y, 1e-4f);
            foreach (Bone bone in SomeBones)
            {
                Assert.True((still[bone].position - moving[bone].position).magnitude < 2e-3f, $"{bone}: {still[bone].position} {moving[bone].position}");
                Assert.True(Quaternion.Angle(still[bone].rotation, moving[bone].rotation) < 0.2f, $"{bone}");
            }
        }
    }

    [Fact]
    public void Only_steps_move_the_root()
    {
        _actor.Put(new Vector3(3, 0, 1), 80);
        MocapSource source = Show();
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(source);
        driver.RootMotionTarget = RootMotionTarget.RootTransform;
        (Vector3 position, Quaternion rotation) = (figure.Root.transform.position, figure.Root.transform.rotation);
        Loop.RunUntil(() => driver.IsDriving);
        AssertAtStart();

        // Neither do a new centre, another place of the stage, and a pause.
        source.Recenter();
        Loop.Frame();
        source.Stage.Offset = new Vector3(1, 0, 0);
        Loop.Frame();
        AssertAtStart();
        driver.enabled = false;
        Put(source, new Vector3(5, 0, 0), 10);
        driver.enabled = true;
        Loop.Frames(2);
        AssertAtStart();

        // Without weight, a figure stays.
        driver.Weight = 0;
        Put(source, new Vector3(1, 0, 0), 10);
        AssertAtStart();

        void AssertAtStart()
        {
            Assert.True((figure.Root.transform.position - position).magnitude < 1e-3f, $"{figure.Root.transform.position}");
            Assert.True(Quaternion.Angle(figure.Root.transform.rotation, rotation) < 0.1f);
        }
    }

    [Fact]
    public void The_way_of_the_performer_during_a_pause_moves_nothing()
    {
        MocapSource source = Show();
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(source);
        driver.RootMotionTarget = RootMotionTarget.RootTransform;
        Loop.RunUntil(() => driver.IsDriving);
        Vector3 start = figure.Root.transform.position;

        driver.PartWeights.Set(BodyParts.Hips, 0);
        Put(source, new Vector3(5, 0, 0), 10);
        driver.PartWeights.Set(BodyParts.Hips, 1);
        Loop.Frames(2);
        AssertNear(start, figure.Root.transform.position);

        // Posed as by Timeline.
        Assert.True(driver.AddPose(driver.Performer!.LocalPose, driver.Performer.Body, 1));
        driver.EndPose(this);
        Put(source, new Vector3(0, 0, 3), 90);
        driver.ReleasePose(this);
        Loop.Frames(2);
        AssertNear(start, figure.Root.transform.position);
    }

    [Fact]
    public void A_model_beside_the_driver_turns_about_its_own_root()
    {
        MocapSource source = Show();
        TestFigure still = TestFigure.Build("Still");
        TestFigure moving = TestFigure.Build("Moving");
        GameObject above = new("Above");
        moving.Root.transform.SetParent(above.transform, true);
        HumanoidDriver[] drivers = [still.Drive(source), above.AddComponent<HumanoidDriver>()];
        (drivers[1].Source, drivers[1].Animator, drivers[1].RootMotionTarget) = (source, moving.Animator, RootMotionTarget.RootTransform);
        Loop.RunUntil(() => drivers.All(static driver => driver.IsDriving));

        Put(source, new Vector3(1, 0, 2), 100);
        AssertNear(still[Bone.Hips].position, moving[Bone.Hips].position);
        AssertNear(still[Bone.LeftHand].position, moving[Bone.LeftHand].position);
        Assert.NotEqual(Vector3.zero, above.transform.position);
    }

    [Fact]
    public void A_model_beside_its_controller_turns_about_its_own_root()
    {
        CharacterController.Floor = -1;
        MocapSource source = Show();
        (HumanoidDriver driver, CharacterController controller) = AddCharacter(source);
        driver.transform.localPosition = new Vector3(0.5f, 0, 0);

        Put(source, new Vector3(0, 0, 0), 90);
        AssertNear(new Vector3(0.5f, 0, 0), driver.transform.position);
        AssertNear(new Vector3(0.5f, 0, 0.5f), controller.transform.position);
    }

    [Fact]
    public void A_pause_ends_a_fall_and_rebinding_finds_another_controller()
    {
        MocapSource source = Show();
        (HumanoidDriver driver, CharacterController controller) = AddCharacter(source);
        Loop.Frames(10);
        driver.enabled = false;
        driver.enabled = true;
        float height = controller.transform.position.y;
        Loop.Frame();
        Assert.Equal(-9.81f / (60 * 60), controller.transform.position.y - height, 1e-4f);

        CharacterController other = new GameObject("Other").AddComponent<CharacterController>();
        driver.transform.SetParent(other.transform, false);
        driver.Rebind();
        Loop.Frame();
        height = controller.transform.position.y;
        Loop.Frames(2);
        Assert.Equal(height, controller.transform.position.y);
        Assert.InRange(other.transform.position.y, -0.1f, -0.001f);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void The_colliders_of_the_figure_do_not_stop_its_controller(bool addsLater)
    {
        MocapSource source = Show();
        (HumanoidDriver driver, CharacterController controller) = AddCharacter(source, hasColliders: !addsLater);
        if (addsLater)
            Assert.NotEqual(0, FigureColliders.Add(driver));

        Put(source, new Vector3(1, 0, 1), 0);
        Assert.Equal(1, controller.transform.position.x, 5e-3f);
        Assert.Equal(1, controller.transform.position.z, 5e-3f);
    }

    [Fact]
    public void A_controller_falls_lands_and_collides()
    {
        MocapSource source = Show();
        (HumanoidDriver driver, CharacterController controller) = AddCharacter(source);
        controller.transform.position = new Vector3(0, 2, 0);

        // Not before: a long first frame moves the controller, which would then be on the floor already.
        CharacterController.Floor = 0;
        CharacterController.Wall = 2;
        Loop.RunUntil(() => controller.isGrounded);
        Assert.Equal(1, controller.transform.position.y, 1e-4f);

        Put(source, new Vector3(1, 0, 1), 90);
        AssertNear(new Vector3(1, 1, 1), controller.transform.position);
        Assert.True(Quaternion.Angle(Quaternion.Euler(0, 90, 0), controller.transform.rotation) < 0.2f);
        Assert.True(controller.isGrounded);

        // The wall ends at half a metre, the radius.
        Put(source, new Vector3(5, 0, 1), 90);
        AssertNear(new Vector3(1.5f, 1, 1), controller.transform.position);
        Put(source, new Vector3(4.5f, 0, 1), 90);
        AssertNear(new Vector3(1, 1, 1), controller.transform.position);
        Assert.Equal(string.Empty, driver.Problem);
    }

    [Fact]
    public void A_fall_gets_faster_and_starts_anew_after_landing()
    {
        MocapSource source = Show();
        (_, CharacterController controller) = AddCharacter(source);
        float first = Fall();
        float second = Fall();
        Assert.True(second < first && first < 0, $"{first} {second}");

        CharacterController.Floor = controller.transform.position.y - 1;
        Loop.Frames(2);
        Assert.True(controller.isGrounded);
        CharacterController.Floor = float.NegativeInfinity;
        Assert.Equal(-9.81f / (60 * 60), Fall(), 1e-4f);

        float Fall()
        {
            float before = controller.transform.position.y;
            Loop.Frame();
            return controller.transform.position.y - before;
        }
    }

    [Fact]
    public void Steps_too_short_for_a_controller_add_up()
    {
        CharacterController.Floor = -1;
        MocapSource source = Show();
        (_, CharacterController controller) = AddCharacter(source);
        controller.minMoveDistance = 0.05f;

        for (int step = 1; step <= 20; step++)
            Put(source, new Vector3(0, 0, step * 0.02f), 0);

        Assert.InRange(controller.transform.position.z, 0.34f, 0.41f);
    }

    [Fact]
    public void A_missing_controller_is_explained()
    {
        MocapSource source = Show();
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(source);
        driver.RootMotionTarget = RootMotionTarget.CharacterController;

        Loop.RunUntil(() => driver.Problem.Contains("No Character Controller", StringComparison.Ordinal));

        figure.Root.AddComponent<CharacterController>();
        Loop.RunUntil(() => driver.Problem.Length == 0);
    }

    private static void AssertNear(Vector3 expected, Vector3 actual) => Assert.True((expected - actual).magnitude < 5e-3f, $"{expected} {actual}");

    private MocapSource Show() => Add(Serve(new BroadcasterOptions { Sources = [_actor], IncludeDisplacement = true }), static source => source.Resample = false);

    // A character of the actor's size below a controller, with its first pose.
    private (HumanoidDriver Driver, CharacterController Controller) AddCharacter(MocapSource source, bool hasColliders = false)
    {
        CharacterController controller = new GameObject("Character").AddComponent<CharacterController>();
        HumanoidFigure figure = HumanoidFigure.Build(Skeleton.SkeletonBody.GetDefault());
        figure.Root.transform.SetParent(controller.transform, false);
        HumanoidDriver driver = figure.Root.AddComponent<HumanoidDriver>();
        driver.Source = source;
        driver.RootMotionTarget = RootMotionTarget.CharacterController;
        if (hasColliders)
            FigureColliders.Add(driver);

        Loop.RunUntil(() => driver.IsDriving);
        return (driver, controller);
    }

    // Waits until the actor's new place has arrived and the figures have followed.
    private void Put(MocapSource source, Vector3 position, float heading)
    {
        _actor.Put(position, heading);
        Loop.RunUntil(() =>
        {
            source.Performers[0].StreamedHips.ToUnity(out Vector3 hips, out Quaternion turn);
            Vector3 way = hips - position;
            return (way - new Vector3(0, way.y, 0)).magnitude < 2e-3f && Quaternion.Angle(turn, Quaternion.Euler(0, heading, 0)) < 0.2f;
        });
    }
}
