using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEngine.Events;

namespace NeuronMocap.Unity.Tests.Figures;

public sealed class PerformerSpawnerTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Every_performer_gets_a_figure_that_moves_like_it()
    {
        MocapSource source = Stage.AddSimulator(performers: 3);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        var spawned = new List<SpawnedFigure>();
        spawner.Spawned += spawned.Add;

        _loop.RunUntil(() => spawner.Figures.Count == 3 && spawner.Figures.All(static figure => figure.Driver.IsDriving));

        Assert.Equal(spawned, spawner.Figures);
        Assert.Equal([0, 1, 2], spawner.Figures.Select(static figure => figure.Performer.AvatarIndex).Order());
        Assert.All(spawner.Figures, figure =>
        {
            HumanoidFigure shown = figure.Root.GetComponent<FigureBuilder>().Figure!;
            Assert.True((shown.GetBone(Bone.Hips).position - figure.Performer.GetPosition(Bone.Hips)).magnitude < 0.02f);
            Assert.Equal(spawner.transform, figure.Root.transform.parent);
        });
        Assert.DoesNotContain(ConsoleLog.Entries, static entry => entry.Type is LogType.Error or LogType.Exception);
    }

    [Fact]
    public void Figures_rest_return_and_leave_with_their_data()
    {
        MocapSource source = Stage.AddSimulator(performers: 2);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.BlendSeconds = 0.2f;
        spawner.DespawnSeconds = 0;
        var despawning = new List<SpawnedFigure>();
        spawner.Despawning += despawning.Add;
        int idleChanges = 0;
        spawner.IdleChanged += _ => idleChanges++;
        _loop.RunUntil(() => spawner.Figures.Count == 2 && spawner.Figures.All(static figure => figure.Driver.IsDriving));

        source.Close();
        _loop.Frames(30);
        SpawnedFigure first = spawner.Figures[0];
        Assert.True(first.IsIdle);
        Assert.Equal(2, idleChanges);
        HumanoidFigure figure = first.Root.GetComponent<FigureBuilder>().Figure!;
        Assert.All((Bone[])[Bone.LeftHand, Bone.RightHand], hand =>
        {
            Bone arm = hand == Bone.LeftHand ? Bone.LeftArm : Bone.RightArm;
            Assert.True(figure.GetBone(hand).position.y < figure.GetBone(arm).position.y - 0.4f, "The arm does not hang down.");
        });
        Assert.Equal(figure.Body.GetOffset(Bone.Hips).Y / 100, figure.GetBone(Bone.Hips).position.y, 0.01);
        Assert.True(figure.GetBone(Bone.LeftHand).position.x < figure.GetBone(Bone.RightHand).position.x
            || Vector3.Angle(figure.GetBone(Bone.Hips).right, Vector3.right) > 90);

        source.Open();
        _loop.RunUntil(() => !first.IsIdle && first.Driver.IsDriving);
        _loop.Frames(30);
        Assert.Equal(2, spawner.Figures.Count);
        Assert.True((figure.GetBone(Bone.LeftHand).position - first.Performer.GetPosition(Bone.LeftHand)).magnitude < 0.05f);

        spawner.DespawnSeconds = 0.5f;
        source.Close();
        _loop.Frames(60);
        Assert.Empty(spawner.Figures);
        Assert.Equal(2, despawning.Count);
        Assert.Equal(0, spawner.transform.childCount);
    }

    [Fact]
    public void Figures_rest_and_leave_in_the_time_of_a_captured_film()
    {
        MocapSource source = Stage.AddSimulator();
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.BlendSeconds = 5;
        spawner.DespawnSeconds = 18;
        _loop.RunUntil(() => spawner.Figures.Count == 1 && spawner.Figures[0].Driver.IsDriving);
        HumanoidFigure figure = spawner.Figures[0].Root.GetComponent<FigureBuilder>().Figure!;

        source.Close();
        Time.captureDeltaTime = 2.5f;
        _loop.Frames(5, 0.001f);
        Assert.True(figure.GetBone(Bone.LeftHand).position.y < figure.GetBone(Bone.LeftArm).position.y - 0.4f, "The arm does not hang down.");
        Assert.Single(spawner.Figures);

        _loop.Frames(4, 0.001f);
        Assert.Empty(spawner.Figures);
    }

    [Fact]
    public void A_figure_that_was_idle_still_mixes_with_its_rest_pose()
    {
        MocapSource source = Stage.AddSimulator();
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.BlendSeconds = 0.2f;
        spawner.DespawnSeconds = 0;
        _loop.RunUntil(() => spawner.Figures.Count == 1 && spawner.Figures[0].Driver.IsDriving);
        source.Close();
        _loop.Frames(30);
        source.Open();
        SpawnedFigure figure = spawner.Figures[0];
        _loop.RunUntil(() => !figure.IsIdle && figure.Driver.IsDriving);
        _loop.Frames(30);

        figure.Driver.Weight = 0.5f;
        _loop.Frame();
        Quaternion turn = figure.Performer.LocalPose[(int)Bone.LeftArm].Rotation.ToUnityRotation();
        Transform arm = figure.Root.GetComponent<FigureBuilder>().Figure!.GetBone(Bone.LeftArm);
        Assert.True(Quaternion.Angle(Quaternion.Slerp(Quaternion.identity, turn, 0.5f), arm.localRotation) < 0.1f, $"{turn} {arm.localRotation}");
    }

    [Fact]
    public void Hidden_figures_come_back()
    {
        MocapSource source = Stage.AddSimulator();
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.IdlePose = IdlePose.Hide;
        spawner.DespawnSeconds = 0;
        _loop.RunUntil(() => spawner.Figures.Count == 1);

        source.Close();
        _loop.Frames(2);
        Assert.False(spawner.Figures[0].Root.activeSelf);

        source.Open();
        _loop.RunUntil(() => spawner.Figures[0].Root.activeSelf && spawner.Figures[0].Driver.IsDriving);
    }

    [Fact]
    public void The_limit_of_figures_is_kept()
    {
        MocapSource source = Stage.AddSimulator(performers: 3);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.MaxFigures = 2;
        _loop.RunUntil(() => Stage.IsLive(source, 3));
        _loop.Frames(3);

        Assert.Equal(2, spawner.Figures.Count);
        Assert.Contains("Max Figures", spawner.Problem);

        spawner.MaxFigures = 3;
        _loop.Frames(2);
        Assert.Equal(3, spawner.Figures.Count);
        Assert.Empty(spawner.Problem);
    }

    [Theory]
    [InlineData(FigurePlacement.SharedStage, 0, 0, 0, 0)]
    [InlineData(FigurePlacement.Row, 2, 0, -2, 0)]
    [InlineData(FigurePlacement.Grid, 1, 0, -1, -2)]
    public void Figures_are_placed_as_configured(FigurePlacement placement, float secondX, float secondZ, float thirdX, float thirdZ)
    {
        MocapSource source = Stage.AddSimulator(performers: 3);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.Placement = placement;
        spawner.Spacing = 2;
        spawner.Columns = 2;
        _loop.RunUntil(() => spawner.Figures.Count == 3);

        Assert.Equal(new Vector3(secondX, 0, secondZ), spawner.Figures[1].Root.transform.localPosition);
        Assert.Equal(new Vector3(thirdX, 0, thirdZ), spawner.Figures[2].Root.transform.localPosition);
    }

    [Fact]
    public void A_prefab_gets_a_driver()
    {
        GameObject prefab = HumanoidFigure.Build(SkeletonBody.GetDefault()).Root;
        MocapSource source = Stage.AddSimulator();
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.Prefab = prefab;

        _loop.RunUntil(() => spawner.Figures.Count == 1 && spawner.Figures[0].Driver.IsDriving);

        Assert.Equal(spawner.Figures[0].Root, spawner.Figures[0].Driver.gameObject);
        Assert.Equal(source, spawner.Figures[0].Driver.ActiveSource);
    }

    [Fact]
    public void A_prefab_without_a_humanoid_is_reported_once()
    {
        GameObject prefab = _loop.CreatePrefab("Box");
        MocapSource source = Stage.AddSimulator();
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.Prefab = prefab;
        _loop.RunUntil(() => Stage.IsLive(source));
        _loop.Frames(3);
        int before = Measure.LiveObjects;
        _loop.Frames(3);

        Assert.Empty(spawner.Figures);
        Assert.Contains("Box", spawner.Problem);
        Assert.Equal(before, Measure.LiveObjects);
    }

    [Fact]
    public void A_destroyed_spawner_leaves_nothing()
    {
        _ = Shader.Find("Standard");
        MocapSource source = Stage.AddSimulator(performers: 2);
        _loop.RunUntil(() => Stage.IsLive(source, 2));
        int before = Measure.LiveObjects;
        PerformerSpawner spawner = Stage.AddSpawner(source);
        _loop.RunUntil(() => spawner.Figures.Count == 2);

        Object.Destroy(spawner.gameObject);
        _loop.Frames(2);

        Assert.Equal(before, Measure.LiveObjects);
    }

    [Fact]
    public void A_frame_allocates_nothing()
    {
        MocapSource source = Stage.AddSimulator(performers: 2);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        _loop.RunUntil(() => spawner.Figures.Count == 2 && Stage.IsLive(source, 2));

        Assert.Equal(0, Measure.BytesPerFrame(_loop, spawner, "Update"));

        spawner.DespawnSeconds = 0;
        source.Close();
        Assert.Equal(0, Measure.BytesPerFrame(_loop, spawner, "Update"));
        Assert.Equal(0, Measure.BytesPerFrame(_loop, spawner.Figures[0].Driver, "LateUpdate"));
        Assert.All(spawner.Figures, static figure => Assert.True(figure.IsIdle));
    }

    [Fact]
    public void Figures_rest_and_leave_in_a_paused_game()
    {
        MocapSource source = Stage.AddSimulator(performers: 2);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.DespawnSeconds = 0.5f;
        _loop.RunUntil(() => spawner.Figures.Count == 2);
        Time.timeScale = 0;
        source.Close();
        _loop.Frames(60);

        Assert.Empty(spawner.Figures);
    }

    [Fact]
    public void A_spawn_handler_may_disable_the_spawner()
    {
        MocapSource source = Stage.AddSimulator(performers: 3);
        _loop.RunUntil(() => Stage.IsLive(source, 3));
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.Spawned += _ => spawner.enabled = false;
        _loop.RunUntil(() => !spawner.enabled);
        _loop.Frames(3);

        Assert.Empty(spawner.Figures);
        Assert.Equal(0, spawner.transform.childCount);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_leave_handler_may_disable_the_spawner(bool whenIdle)
    {
        MocapSource source = Stage.AddSimulator(performers: 3);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        _loop.RunUntil(() => spawner.Figures.Count == 3);
        spawner.DespawnSeconds = 0.2f;
        if (whenIdle)
            spawner.IdleChanged += _ => spawner.enabled = false;
        else
            spawner.Despawning += _ => spawner.enabled = false;

        source.Close();
        _loop.Frames(60);

        Assert.Empty(spawner.Figures);
        Assert.Equal(0, spawner.transform.childCount);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void Built_figures_have_the_material_of_the_spawner()
    {
        PerformerSpawner spawner = Stage.AddSpawner(Stage.AddSimulator());
        spawner.Material = new Material(Shader.Find("Standard")!);
        spawner.Material.SetFloat("_Glossiness", 0.9f);
        Material? shown = null;
        spawner.Spawned += figure => figure.Root.GetComponent<FigureBuilder>().Built += built => shown = built.Renderer.sharedMaterials[0];
        _loop.RunUntil(() => shown is not null);

        Assert.NotSame(spawner.Material, shown);
        Assert.Equal(0.9f, shown!.GetFloat("_Glossiness"));
    }

    [Fact]
    public void A_valid_prefab_clears_the_problem()
    {
        MocapSource source = Stage.AddSimulator();
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.Prefab = _loop.CreatePrefab("Stone");
        _loop.RunUntil(() => spawner.Problem.Length > 0);
        spawner.Prefab = null;
        _loop.RunUntil(() => spawner.Figures.Count == 1);

        Assert.Equal("", spawner.Problem);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_leave_handler_that_throws_keeps_no_figure(bool inInspector)
    {
        MocapSource source = Stage.AddSimulator(performers: 3);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        _loop.RunUntil(() => spawner.Figures.Count == 3);
        if (inInspector)
            ((UnityEvent<GameObject>)Measure.Field(spawner, "_onDespawning")!).AddListener(static _ => throw new InvalidOperationException("despawning"));
        else
            spawner.Despawning += static _ => throw new InvalidOperationException("despawning");

        spawner.enabled = false;
        _loop.Frames(2);

        Assert.Empty(spawner.Figures);
        Assert.Equal(0, spawner.transform.childCount);
        Assert.Equal(3, ConsoleLog.Entries.Count);
        Assert.All(ConsoleLog.Entries, entry => Assert.Equal(("despawning", spawner), (entry.Exception!.Message, entry.Context)));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Handlers_that_throw_delay_no_other_figure(bool inInspector)
    {
        MocapSource source = Stage.AddSimulator(performers: 3);
        _loop.RunUntil(() => Stage.IsLive(source, 3));
        PerformerSpawner spawner = Stage.AddSpawner(source);
        if (inInspector)
            ((UnityEvent<GameObject>)Measure.Field(spawner, "_onSpawned")!).AddListener(static _ => throw new InvalidOperationException("spawned"));
        else
            spawner.Spawned += static _ => throw new InvalidOperationException("spawned");

        spawner.IdleChanged += static _ => throw new InvalidOperationException("idle");
        _loop.Frame();
        Assert.Equal(3, spawner.Figures.Count);

        source.Close();
        _loop.Frame();
        Assert.All(spawner.Figures, static figure => Assert.True(figure.IsIdle));
        Assert.Equal(["idle", "idle", "idle", "spawned", "spawned", "spawned"], ConsoleLog.Entries.Select(static entry => entry.Exception!.Message).Order());
    }
}
