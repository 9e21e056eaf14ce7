using NeuronMocap.Motion;
using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

public sealed class SourceAllocationTests : SourceFixture
{
    [Fact]
    public void A_rendered_frame_allocates_nothing()
    {
        Broadcaster server = Serve(new BroadcasterOptions
        {
            Sources = [new SyntheticSource(), new SyntheticSource(avatarIndex: 1)],
            Calculation = CalculationSynthesizer.Write,
        });
        MocapSource source = Add(server);
        HumanoidDriver byIndex = TestFigure.Build("A").Drive(source);
        HumanoidDriver byName = TestFigure.Build("B").Drive(null);
        (byName.PerformerChoice, byName.PerformerName, byName.FootPlanting, byName.Weight) = (PerformerChoice.ByName, "Char01", true, 0.5f);
        byName.BoneWeights.Add(new HumanoidBoneWeight { Bone = HumanoidBone.Head, Weight = 0 });
        byName.Smoothing = true;
        HumanoidDriver lost = TestFigure.Build("C").Drive(source);
        lost.PerformerIndex = 7;
        Loop.RunUntil(() => byIndex.IsDriving && byName.IsDriving && lost.Problem.Length > 0);
        Loop.RunFor(0.3f);

        Action update = Method(source, "Update");
        Action[] drive = [Method(byIndex, "LateUpdate"), Method(byName, "LateUpdate"), Method(lost, "LateUpdate")];
        Allocations.AssertNone(() =>
        {
            update();
            foreach (Action action in drive)
                action();

            _ = source.FrameRate;
            _ = source.LostFrames;
        });
        Assert.True(byIndex.IsDriving && byName.IsDriving);
    }

    // Whole frames, with everything in them that can be switched on.
    [Theory]
    [InlineData(DriveTime.LateUpdate, RootMotionTarget.RootTransform)]
    [InlineData(DriveTime.Update, RootMotionTarget.CharacterController)]
    [InlineData(DriveTime.Physics, RootMotionTarget.RootTransform)]
    public void A_frame_with_every_option_allocates_nothing(DriveTime time, RootMotionTarget target)
    {
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new SyntheticSource()], Calculation = CalculationSynthesizer.Write, IncludeDisplacement = true });
        MocapSource source = Add(server);
        (source.Stage.Offset, source.Stage.Heading, source.Stage.Mirror, source.Stage.Scale) = (Vector3.one, 30, true, 1.2f);
        TestFigure figure = TestFigure.Build("A");
        figure.Root.AddComponent<CharacterController>();
        HumanoidDriver driver = figure.Drive(source);
        (driver.Smoothing, driver.FootPlanting, driver.Displacement, driver.Weight) = (true, true, true, 0.5f);
        (driver.RootMotionTarget, driver.WhenIdle) = (target, IdleBehaviour.BlendToRest);
        driver.PartWeights.Set(BodyParts.Arms, 0.5f);
        driver.BoneWeights.Add(new HumanoidBoneWeight { Bone = HumanoidBone.Head, Weight = 0 });
        if (time == DriveTime.Physics)
            FigureColliders.Add(driver);

        driver.DriveTime = time;
        HandProp prop = new GameObject("Sword").AddComponent<HandProp>();
        prop.Driver = driver;
        prop.gameObject.AddComponent<Rigidbody>().isKinematic = true;
        FollowCamera follow = new GameObject("Eye").AddComponent<FollowCamera>();
        follow.Target = figure.Root.transform;
        Loop.RunUntil(() => driver.IsDriving);
        source.Recenter();
        Loop.RunFor(0.3f);

        FrameAllocations.AssertNone(Loop);
        Assert.True(driver.IsDriving && driver.Problem.Length == 0, driver.Problem);
    }

    [Fact]
    public void Twenty_figures_with_every_option_allocate_nothing()
    {
        const int Performers = 20;
        MocapSource source = AddSimulator(Performers);
        (source.Stage.Offset, source.Stage.Heading, source.Stage.Mirror, source.Stage.Scale) = (Vector3.one, 30, true, 1.2f);
        HumanoidDriver[] drivers = [.. Enumerable.Range(0, Performers).Select(performer =>
        {
            HumanoidDriver driver = TestFigure.Build($"Figure {performer}").Drive(source);
            driver.PerformerIndex = performer;
            (driver.Smoothing, driver.FootPlanting, driver.Displacement, driver.Weight) = (true, true, true, 0.5f);
            driver.RootMotionTarget = performer % 2 == 0 ? RootMotionTarget.RootTransform : RootMotionTarget.Hips;
            driver.DriveTime = (DriveTime)(performer % 3);
            FigureColliders.Add(driver);
            return driver;
        })];
        Loop.RunUntil(() => Array.TrueForAll(drivers, static driver => driver.IsDriving));
        source.Recenter();
        Loop.RunFor(0.3f);

        FrameAllocations.AssertNone(Loop);
        Assert.All(drivers, static driver => Assert.True(driver.IsDriving && driver.Problem.Length == 0, driver.Problem));
    }

    [Fact]
    public void A_received_frame_allocates_nothing()
    {
        var streams = new AvatarStreams();
        float[] values = new float[354];
        var frame = new MotionFrame(new MotionHeader { FrameIndex = 1 }, values);
        streams.OnMotion(frame);
        streams.All[0].Attach(new PoseBuffer());
        var contacts = new CalculationFrame(new CalculationHeader(), new float[946]);
        Allocations.AssertNone(() =>
        {
            streams.OnMotion(frame);
            streams.OnCalculation(contacts);
        });
        Assert.True(streams.All[0].Frames > 100);
    }

    [Fact]
    public void Forged_avatars_take_bounded_memory()
    {
        var streams = new AvatarStreams();
        float[] values = new float[354];
        for (int avatar = 0; avatar < 1000; avatar++)
            streams.OnMotion(new MotionFrame(new MotionHeader { AvatarIndex = avatar }, values));

        Assert.Equal(256, streams.All.Length);
        Assert.Contains(streams.All, static stream => stream.AvatarIndex == 999);
        foreach (AvatarStream stream in streams.All)
            stream.Attach(new PoseBuffer());

        streams.OnMotion(new MotionFrame(new MotionHeader { AvatarIndex = 5000 }, values));
        Assert.DoesNotContain(streams.All, static stream => stream.AvatarIndex == 5000);
    }

    private static Action Method(MonoBehaviour script, string name)
    {
        for (Type? type = script.GetType(); type is not null; type = type.BaseType)
        {
            if (type.GetMethod(name, System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic | System.Reflection.BindingFlags.DeclaredOnly) is { } method)
                return method.CreateDelegate<Action>(script);
        }

        throw new MissingMethodException(script.GetType().Name, name);
    }
}
