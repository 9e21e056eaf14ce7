using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.DebugViews;

public sealed class SkeletonViewTests : IDisposable
{
    private readonly PlayerLoop _loop = new() { DrawsGizmos = true };

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Bones_and_joints_match_the_performer()
    {
        MocapSource source = Stage.AddSimulator();
        SkeletonView view = AddView(source);
        view.transform.SetPositionAndRotation(new Vector3(2, 0, 1), Quaternion.Euler(0, 90, 0));
        _loop.RunUntil(() => Stage.IsLive(source));
        _loop.Frame();

        Performer performer = source.Performers[0];
        GizmoCall[] lines = [.. GizmoLog.Calls.Where(static call => call.Shape == "Line")];
        Assert.Equal(58 + 13, lines.Length);
        foreach (Bone bone in BoneHierarchy.Bones[1..])
        {
            Vector3 from = view.transform.TransformPoint(performer.GetPosition(BoneHierarchy.GetParent(bone, performer.Variant)!.Value));
            Vector3 to = view.transform.TransformPoint(performer.GetPosition(bone));
            Assert.Contains(lines, line => (line.From - from).magnitude < 1e-4f && (line.To - to).magnitude < 1e-4f);
        }

        Vector3 crown = view.transform.TransformPoint(performer.GetEndPosition(Bone.Head));
        Assert.Contains(lines, line => (line.To - crown).magnitude < 1e-4f);
        int contacts = (performer.Contacts.Left ? 1 : 0) + (performer.Contacts.Right ? 1 : 0);
        Assert.Equal(59 + contacts, GizmoLog.Calls.Count(static call => call.Shape == "Sphere"));
    }

    [Fact]
    public void Feet_on_the_ground_are_marked()
    {
        var actor = new StandingActor(SkeletonBody.GetDefault());
        using NeuronMocap.Server.Broadcaster server = Stage.Broadcast(actor);
        MocapSource source = Stage.AddClient(server);
        SkeletonView view = AddView(source);
        view.ShowJoints = false;
        view.ShowBones = false;
        _loop.RunUntil(() => Stage.IsLive(source) && source.Performers[0].Contacts is { Left: true, Right: true });
        _loop.Frame();

        Assert.Equal(2, GizmoLog.Calls.Count);
        Assert.All(GizmoLog.Calls, static call =>
        {
            Assert.Equal("Sphere", call.Shape);
            Assert.Equal(0, call.From.y, 0.02f);
            Assert.Equal(0.095f, Math.Abs(call.From.x), 0.01f);
        });
    }

    [Fact]
    public void Trails_have_the_configured_length()
    {
        MocapSource source = Stage.AddSimulator();
        SkeletonView view = AddView(source);
        view.ShowBones = false;
        view.ShowJoints = false;
        view.ShowContacts = false;
        view.TrailBones = [Bone.LeftHand];
        view.TrailSeconds = 0.5f;
        _loop.RunUntil(() => Stage.IsLive(source));
        var places = new List<Vector3>();
        for (int i = 0; i < 60; i++)
        {
            _loop.Frame();
            places.Add(source.Performers[0].GetPosition(Bone.LeftHand));
        }

        Assert.InRange(GizmoLog.Calls.Count, 26, 31);
        Assert.Equal(places[^1], GizmoLog.Calls[^1].To);
        Assert.Contains(places, place => (place - GizmoLog.Calls[0].From).magnitude < 1e-5f);
    }

    [Theory]
    [InlineData(RootMotionTarget.RootTransform)]
    [InlineData(RootMotionTarget.CharacterController)]
    public void The_view_stays_at_a_figure_whose_root_travels(RootMotionTarget target)
    {
        MocapSource source = Stage.AddSimulator();
        var holder = new GameObject("Figure");
        holder.transform.SetPositionAndRotation(new Vector3(3, 0, 7), Quaternion.Euler(0, 70, 0));
        holder.AddComponent<CharacterController>().minMoveDistance = 0;
        CharacterController.Floor = -1;
        HumanoidDriver driver = holder.AddComponent<HumanoidDriver>();
        driver.Source = source;
        driver.RootMotionTarget = target;
        FigureBuilder builder = holder.AddComponent<FigureBuilder>();
        SkeletonView view = AddView(null);
        view.Driver = driver;
        Vector3 start = holder.transform.position;

        _loop.RunUntil(() => (holder.transform.position - start).magnitude > 0.4f);

        GizmoCall[] lines = [.. GizmoLog.Calls.Where(static call => call.Shape == "Line")];
        foreach (Bone bone in (Bone[])[Bone.LeftHand, Bone.RightFoot, Bone.Head])
        {
            Vector3 place = builder.Figure!.GetBone(bone).position;
            Assert.Contains(lines, line => (line.To - place).magnitude < 0.05f);
        }
    }

    [Fact]
    public void The_view_stands_at_the_driven_character()
    {
        MocapSource source = Stage.AddSimulator();
        var holder = new GameObject("Figure");
        holder.transform.position = new Vector3(0, 0, 7);
        HumanoidDriver driver = holder.AddComponent<HumanoidDriver>();
        driver.Source = source;
        holder.AddComponent<FigureBuilder>();
        SkeletonView view = AddView(null);
        view.Driver = driver;
        _loop.RunUntil(() => driver.IsDriving);
        _loop.Frame();

        Vector3 hips = driver.Performer!.GetPosition(Bone.Hips) + new Vector3(0, 0, 7);
        Assert.Contains(GizmoLog.Calls, call => call.Shape == "Sphere" && (call.From - hips).magnitude < 1e-4f);
    }

    [Fact]
    public void The_view_stands_at_a_character_below_its_driver()
    {
        var holder = new GameObject("Holder");
        TestFigure figure = TestFigure.Build("Ann");
        figure.Root.transform.SetParent(holder.transform);
        HumanoidDriver driver = holder.AddComponent<HumanoidDriver>();
        driver.Source = Stage.AddSimulator();
        AddView(null).Driver = driver;
        _loop.RunUntil(() => driver.IsDriving);
        _loop.Frame();

        Assert.Null(driver.Animator);
        Assert.Same(figure.Animator, driver.ActiveAnimator);
        Vector3 hips = figure.Root.transform.TransformPoint(driver.Performer!.GetPosition(Bone.Hips));
        Assert.Contains(GizmoLog.Calls, call => call.Shape == "Sphere" && (call.From - hips).magnitude < 1e-4f);

        Object.DestroyImmediate(figure.Root);
        _loop.Frame();
        Assert.Null(driver.ActiveAnimator);
    }

    [Fact]
    public void Nothing_is_drawn_without_a_performer()
    {
        AddView(null);
        _loop.Frames(3);
        Assert.Empty(GizmoLog.Calls);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void A_frame_allocates_nothing()
    {
        MocapSource source = Stage.AddSimulator();
        SkeletonView view = AddView(source);
        view.TrailSeconds = 0.5f;
        _loop.RunUntil(() => Stage.IsLive(source));

        Assert.Equal(0, Measure.BytesPerFrame(_loop, view, "LateUpdate", "OnDrawGizmos"));
    }

    private static SkeletonView AddView(MocapSource? source)
    {
        var view = new GameObject("View").AddComponent<SkeletonView>();
        view.Source = source;
        return view;
    }
}
