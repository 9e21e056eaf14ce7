using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Figures;

public sealed class FigureBuilderTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void The_figure_moves_as_the_performer_does()
    {
        MocapSource source = Stage.AddSimulator();
        FigureBuilder builder = AddBuilder(source);
        _loop.Frame();
        Assert.NotNull(builder.Figure);
        Vector3 start = builder.Figure!.GetBone(Bone.Hips).position;

        _loop.RunUntil(() => Stage.IsLive(source) && (builder.Figure!.GetBone(Bone.Hips).position - start).magnitude > 0.05f);

        Performer performer = source.Performers[0];
        foreach (Bone bone in (Bone[])[Bone.Hips, Bone.LeftHand, Bone.RightFoot, Bone.Head])
        {
            float apart = (builder.Figure.GetBone(bone).position - performer.GetPosition(bone)).magnitude;
            Assert.True(apart < 0.02f, $"{bone} is {apart} m from the performer's.");
        }

        Assert.DoesNotContain(ConsoleLog.Entries, static entry => entry.Type is LogType.Error or LogType.Exception);
    }

    [Fact]
    public void Changed_sizes_rebuild_the_figure_without_leaks()
    {
        _ = Shader.Find("Standard");
        int before = Measure.LiveObjects;
        var actor = new StandingActor(SkeletonBody.GetDefault());
        using Broadcaster server = Stage.Broadcast(actor);
        MocapSource source = Stage.AddClient(server);
        FigureBuilder builder = AddBuilder(source);
        var built = new List<HumanoidFigure>();
        builder.Built += built.Add;
        _loop.RunUntil(() => Stage.IsLive(source));
        int withOneFigure = Measure.LiveObjects;

        SkeletonBody tall = HumanoidFigureTests.Tall(SkeletonVariant.Neck1);
        actor.Body = tall;
        _loop.RunUntil(() => HasSizes(builder, tall));
        _loop.Frames(2);

        Assert.True(built.Count >= 1);
        Assert.Same(builder.Figure, built[^1]);
        Assert.Equal(builder.Figure!.Animator, builder.Driver.Animator);
        Assert.Equal(withOneFigure, Measure.LiveObjects);

        Object.Destroy(builder.gameObject);
        Object.Destroy(source.gameObject);
        _loop.Frames(2);
        Assert.Equal(before, Measure.LiveObjects);
    }

    [Fact]
    public void Disabling_removes_the_figure_and_enabling_restores_it()
    {
        FigureBuilder builder = AddBuilder(null);
        _loop.Frame();
        int with = Measure.LiveObjects;

        builder.enabled = false;
        _loop.Frame();
        Assert.Null(builder.Figure);
        Assert.Equal(0, builder.transform.childCount);

        builder.enabled = true;
        _loop.Frame();
        Assert.NotNull(builder.Figure);
        Assert.Equal(with, Measure.LiveObjects);
    }

    [Fact]
    public void Nothing_is_rebuilt_while_its_object_or_itself_is_disabled()
    {
        var holder = new GameObject("Figure");
        holder.SetActive(false);
        FigureBuilder builder = holder.AddComponent<FigureBuilder>();
        builder.Rebuild();
        Assert.Null(builder.Figure);

        holder.SetActive(true);
        _loop.Frame();
        Assert.NotNull(builder.Figure);

        builder.enabled = false;
        builder.Rebuild();
        _loop.Frame();
        Assert.Null(builder.Figure);
        Assert.Equal(0, builder.transform.childCount);
    }

    [Fact]
    public void Its_object_may_be_deactivated_and_activated()
    {
        FigureBuilder builder = AddBuilder(null);
        _loop.Frame();
        int with = Measure.LiveObjects;

        builder.gameObject.SetActive(false);
        _loop.Frame();
        Assert.Null(builder.Figure);

        builder.gameObject.SetActive(true);
        _loop.Frame();
        Assert.Same(builder.transform, builder.Figure!.Root.transform.parent);
        Assert.Equal(with, Measure.LiveObjects);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void Scripts_compiled_in_play_mode_leave_nothing_behind()
    {
        FigureBuilder builder = AddBuilder(null);
        _loop.Frame();
        int with = Measure.LiveObjects;

        _loop.ReloadDomain();
        _loop.Frames(2);

        Assert.NotNull(builder.Figure);
        Assert.Equal(with, Measure.LiveObjects);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void A_destroyed_figure_is_rebuilt()
    {
        MocapSource source = Stage.AddSimulator();
        FigureBuilder builder = AddBuilder(source);
        _loop.RunUntil(() => Stage.IsLive(source));

        Object.Destroy(builder.Figure!.Root);
        _loop.RunUntil(() => builder.Figure is { IsDestroyed: false });

        Assert.True(builder.Figure!.Animator.isHuman);
    }

    [Fact]
    public void A_handler_that_throws_leaves_one_figure()
    {
        FigureBuilder builder = AddBuilder(null);
        _loop.Frame();
        HumanoidFigure before = builder.Figure!;
        builder.Built += static _ => throw new InvalidOperationException("built");

        builder.Rebuild();
        _loop.Frame();

        Assert.NotSame(before, builder.Figure);
        Assert.Same(builder.Figure!.Root.transform, Assert.Single(builder.transform.Cast<Transform>()));
        Assert.Equal("built", Assert.Single(ConsoleLog.Entries).Exception!.Message);
    }

    [Fact]
    public void A_frame_allocates_nothing()
    {
        MocapSource source = Stage.AddSimulator();
        FigureBuilder builder = AddBuilder(source);
        _loop.RunUntil(() => Stage.IsLive(source));

        Assert.Equal(0, Measure.BytesPerFrame(_loop, builder, "Update"));
    }

    private static FigureBuilder AddBuilder(MocapSource? source)
    {
        var holder = new GameObject("Figure");
        holder.AddComponent<HumanoidDriver>().Source = source;
        return holder.AddComponent<FigureBuilder>();
    }

    private static bool HasSizes(FigureBuilder builder, SkeletonBody body) => builder.Figure is { IsDestroyed: false } figure
        && BoneHierarchy.Bones[1..].ToArray().All(bone => (figure.Body.GetOffset(bone) - body.GetOffset(bone)).Length() < 0.1f);
}
