using NeuronMocap.Server;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

/// <summary>The stage of a source: where its performers are, and what follows from that.</summary>
public sealed class SourceStageTests : SourceFixture
{
    private static readonly Bone[] SomeBones = [Bone.Hips, Bone.Head, Bone.LeftHand, Bone.RightHand, Bone.LeftFoot, Bone.RightHandThumb3];

    [Fact]
    public void The_stage_is_scaled_turned_and_moved()
    {
        (MocapSource source, Performer performer) = Show(new Vector3(1, 0.2f, 2), 30);
        (Vector3 Position, Quaternion Rotation)[] before = Measure(performer);
        float leg = performer.Body.GetOffset(Bone.LeftLeg).Length();
        int bodies = performer.BodyVersion;

        (source.Stage.Offset, source.Stage.Heading, source.Stage.Scale) = (new Vector3(5, 0.5f, -3), 70, 1.5f);
        Loop.Frame();

        Quaternion turn = Quaternion.Euler(0, 70, 0);
        (Vector3 Position, Quaternion Rotation)[] after = Measure(performer);
        for (int i = 0; i < before.Length; i++)
        {
            AssertNear(new Vector3(5, 0.5f, -3) + (turn * (before[i].Position * 1.5f)), after[i].Position);
            AssertNear(turn * before[i].Rotation, after[i].Rotation);
        }

        Assert.Equal(leg * 1.5f, performer.Body.GetOffset(Bone.LeftLeg).Length(), 1e-3f);
        Assert.Equal(bodies + 1, performer.BodyVersion);
        Loop.Frame();
        Assert.Equal(bodies + 1, performer.BodyVersion);
    }

    [Fact]
    public void A_mirror_swaps_left_and_right()
    {
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [Placed(new Vector3(1, 0, 2), 30)], Calculation = CalculationSynthesizer.Write, IncludeDisplacement = true });
        MocapSource source = Add(server, static source => source.Resample = false);
        Performer performer = WaitForPose(source);
        Loop.RunUntil(() => performer.HasMeasuredContacts);
        Assert.Equal(new FootContacts(true, false), performer.Contacts);
        Vector3 left = performer.GetPosition(Bone.LeftHand);
        Quaternion turned = performer.GetRotation(Bone.LeftArm);
        Vector3 end = performer.GetEndPosition(Bone.LeftFoot);

        source.Stage.Mirror = true;
        Loop.RunUntil(() => performer.HasMeasuredContacts && performer.Contacts.Right);

        AssertNear(Vector3.Scale(left, new Vector3(-1, 1, 1)), performer.GetPosition(Bone.RightHand));
        AssertNear(Vector3.Scale(end, new Vector3(-1, 1, 1)), performer.GetEndPosition(Bone.RightFoot));
        AssertNear(new Quaternion(turned.x, -turned.y, -turned.z, turned.w), performer.GetRotation(Bone.RightArm));
        Assert.False(performer.Contacts.Left);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Recentring_puts_the_hips_at_the_origin(bool isMirrored)
    {
        var actors = new[] { Placed(new Vector3(1, 0.3f, 2), 140), Placed(new Vector3(3, 0, 2), 0) };
        MocapSource source = Add(Serve(actors), static source => source.Resample = false);
        source.Stage.Mirror = isMirrored;
        source.Recenter();
        Performer first = WaitForPose(source);
        Performer second = WaitForPose(source, 1);
        Loop.Frame();
        Vector3 apart = first.GetPosition(Bone.Hips) - second.GetPosition(Bone.Hips);
        Vector3 before = first.GetPosition(Bone.Hips);
        Assert.True(before.magnitude > 2);

        source.Recenter();
        Loop.Frame();

        AssertNear(new Vector3(0, before.y, 0), first.GetPosition(Bone.Hips));
        AssertNear(Quaternion.identity, first.GetRotation(Bone.Hips));
        Assert.Equal(apart.magnitude, (first.GetPosition(Bone.Hips) - second.GetPosition(Bone.Hips)).magnitude, 1e-3f);

        // The stage moves what was recentred.
        (source.Stage.Offset, source.Stage.Heading) = (new Vector3(0, 0, 4), 90);
        Assert.True(source.Recenter(second));
        Loop.Frame();
        AssertNear(new Vector3(0, second.GetPosition(Bone.Hips).y, 4), second.GetPosition(Bone.Hips));
        AssertNear(Quaternion.Euler(0, 90, 0), second.GetRotation(Bone.Hips));

        (source.Stage.Offset, source.Stage.Heading) = (Vector3.zero, 0);
        source.ClearCenter();
        Loop.Frame();
        AssertNear(before, first.GetPosition(Bone.Hips));
    }

    [Fact]
    public void A_performer_of_another_source_cannot_be_the_centre()
    {
        (MocapSource source, _) = Show(Vector3.zero, 0);
        (_, Performer other) = Show(Vector3.zero, 0);

        Assert.False(source.Recenter(other));
        Assert.Throws<ArgumentNullException>(() => source.Recenter(null!));
    }

    [Fact]
    public void Values_that_are_no_numbers_are_ignored()
    {
        (MocapSource source, Performer performer) = Show(new Vector3(1, 0, 2), 30);
        Vector3 before = performer.GetPosition(Bone.Head);

        (source.Stage.Offset, source.Stage.Heading, source.Stage.Scale) = (new Vector3(float.NaN, 0, 0), float.PositiveInfinity, 0);
        Loop.Frame();

        AssertNear(before, performer.GetPosition(Bone.Head));
    }

    [Fact]
    public void Figures_of_every_size_are_moved_by_the_same_distance()
    {
        (MocapSource here, _) = Show(new Vector3(1, 0, 2), 30);
        (MocapSource there, _) = Show(new Vector3(1, 0, 2), 30);
        there.Stage.Offset = new Vector3(4, 0, -1);
        there.Stage.Heading = 0;
        (TestFigure Near, TestFigure Far)[] pairs = [(TestFigure.Build("A", size: 0.5f), TestFigure.Build("B", size: 0.5f)), (TestFigure.Build("C"), TestFigure.Build("D"))];
        HumanoidDriver[] drivers = [.. pairs.SelectMany(pair => (HumanoidDriver[])[pair.Near.Drive(here), pair.Far.Drive(there)])];
        Loop.RunUntil(() => drivers.All(static driver => driver.IsDriving));

        foreach ((TestFigure near, TestFigure far) in pairs)
        {
            // In the space of the root, which is turned and scaled.
            Vector3 way = far.Root.transform.InverseTransformPoint(far[Bone.Hips].position) - near.Root.transform.InverseTransformPoint(near[Bone.Hips].position);
            AssertNear(new Vector3(4, 0, -1), way);
        }
    }

    [Fact]
    public void Several_sources_on_one_stage_allocate_nothing()
    {
        (MocapSource first, _) = Show(new Vector3(1, 0, 2), 30);
        (MocapSource second, _) = Show(new Vector3(-1, 0, 0), 0);
        (first.Stage.Offset, first.Stage.Mirror) = (new Vector3(2, 0, 0), true);
        (second.Stage.Offset, second.Stage.Heading, second.Stage.Scale) = (new Vector3(-2, 0, 0), 45, 2);
        second.Recenter();
        HumanoidDriver[] drivers = [TestFigure.Build("A", size: 0.5f).Drive(first), TestFigure.Build("B").Drive(second), TestFigure.Build("C").Drive(second)];
        drivers[1].RootMotionTarget = RootMotionTarget.RootTransform;
        drivers[2].RootMotionTarget = RootMotionTarget.CharacterController;
        drivers[2].gameObject.AddComponent<CharacterController>();
        Loop.RunUntil(() => drivers.All(static driver => driver.IsDriving));

        FrameAllocations.AssertNone(Loop);
        Assert.All(drivers, static driver => Assert.True(driver.IsDriving && driver.Problem.Length == 0));
    }

    private static PlacedActor Placed(Vector3 position, float heading)
    {
        var actor = new PlacedActor();
        actor.Put(position, heading);
        return actor;
    }

    private static (Vector3 Position, Quaternion Rotation)[] Measure(Performer performer) =>
        [.. SomeBones.Select(bone => (performer.GetPosition(bone), performer.GetRotation(bone)))];

    private static void AssertNear(Vector3 expected, Vector3 actual) => Assert.True((expected - actual).magnitude < 2e-3f, $"{expected} {actual}");

    private static void AssertNear(Quaternion expected, Quaternion actual) => Assert.True(Quaternion.Angle(expected, actual) < 0.2f, $"{expected} {actual}");

    private (MocapSource Source, Performer Performer) Show(Vector3 position, float heading)
    {
        MocapSource source = Add(Serve(new BroadcasterOptions { Sources = [Placed(position, heading)], IncludeDisplacement = true }), static source => source.Resample = false);
        return (source, WaitForPose(source));
    }
}
