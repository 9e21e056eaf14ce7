using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Samples;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEngine.Rendering;

namespace NeuronMocap.Unity.Tests.Samples;

public sealed partial class SampleSceneTests : IDisposable
{
    private static readonly string Folder = Path.Combine(Repository.Root, "unity-package", "Samples~");

    private readonly PlayerLoop _loop = new() { DrawsGizmos = true };

    public static TheoryData<string> Scenes => [.. Directory.EnumerateDirectories(Folder).Select(static folder => Path.GetFileName(folder)!).Order(StringComparer.Ordinal)];

    public void Dispose() => _loop.Dispose();

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_scene_refers_to_existing_scripts_fields_and_objects(string sample)
    {
        SceneFile scene = Read(sample);

        long[] ids = [.. scene.Documents.Select(static document => document.Id)];
        Assert.Equal(ids.Distinct(), ids);
        Assert.NotEmpty(scene.Scripts);
        foreach (SceneFile.Document script in scene.Scripts.Where(static script => !SceneFile.VendorScripts.Contains(SceneFile.Guid(script))))
        {
            Type type = SceneFile.FindScript(SceneFile.Guid(script));
            Assert.All(script.Values.Keys.Where(static name => name.StartsWith('_')), name => Assert.NotNull(SceneFile.FindField(type, name)));
        }

        foreach (SceneFile.Document item in scene.Documents)
        {
            IEnumerable<string> references = item.Values.Where(static pair => pair.Key != "m_Script").Select(static pair => pair.Value)
                .Concat(item.Items.Select(static text => text.Replace("component: ", "", StringComparison.Ordinal)))
                .Where(static text => text.StartsWith("{fileID: ", StringComparison.Ordinal) && !text.Contains("guid: ", StringComparison.Ordinal));
            Assert.All(references, text => Assert.True(SceneFile.Reference(text) == 0 || ids.Contains(SceneFile.Reference(text)), $"{item.Id}: {text}"));
        }

        // The components listed by an object are those that name it as their object.
        foreach (SceneFile.Document item in scene.Documents.Where(static document => document.Class == 1))
        {
            Assert.Equal(
                scene.Documents.Where(part => part.Values.TryGetValue("m_GameObject", out string? owner) && SceneFile.Reference(owner) == item.Id).Select(static part => part.Id),
                item.Items.Select(static text => SceneFile.Reference(text["component: ".Length..])));
        }
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_sample_describes_itself_in_a_few_lines(string sample)
    {
        string[] lines = File.ReadAllLines(Path.Combine(Folder, sample, "README.md"));
        Assert.StartsWith("# ", lines[0]);
        Assert.InRange(lines.Length, 3, 25);
    }

    [Fact]
    public void Quick_start_needs_one_component()
    {
        Assert.Single(Read("QuickStart").Scripts);
        Read("QuickStart").Build();
        _loop.Frame();

        FigureBuilder builder = Find<FigureBuilder>();
        Moves(() => builder.Figure);
        Assert.NotNull(Find<Light>());
        Assert.NotNull(World.Objects.OfType<GameObject>().Single(static item => item.name == "Ground"));

        // The camera looks at the figure from a few metres away.
        Transform camera = Camera.main!.transform;
        _loop.RunFor(0.5f);
        Vector3 way = builder.Figure!.GetBone(Bone.Hips).position - camera.position;
        Assert.InRange(way.magnitude, 1.5f, 7);
        Assert.True(Vector3.Angle(camera.forward, way) < 25);
    }

    [Fact]
    public void Quick_start_takes_a_real_stream_too()
    {
        var actor = new StandingActor(HumanoidFigureSizes.Tall);
        using NeuronMocap.Server.Broadcaster server = Stage.Broadcast(actor);
        QuickStart start = new GameObject("Start").AddComponent<QuickStart>();
        start.UseSimulator = false;
        SceneFile.FindField(typeof(QuickStart), "_port")!.SetValue(start, server.LocalEndPoint!.Port);

        _loop.RunUntil(() => start.Source != null && Stage.IsLive(start.Source) && start.Builder!.Driver.IsDriving);
    }

    [Fact]
    public void Many_performers_join_and_leave()
    {
        Read("ManyPerformers").Build();
        PerformerSpawner spawner = Find<PerformerSpawner>();
        Crowd crowd = Find<Crowd>();

        _loop.RunUntil(() => spawner.Figures.Count == 6 && spawner.Figures.All(static figure => figure.Driver.IsDriving));
        Vector3[] places = [.. spawner.Figures.Select(static figure => figure.Root.transform.localPosition)];
        Assert.Equal(6, places.Distinct().Count());

        Click(crowd, "One more (key M)");
        _loop.RunUntil(() => spawner.Figures.Count == 7);
        Assert.Contains(Shown(crowd), static text => text.Contains("7 figures of 7", StringComparison.Ordinal));
    }

    [Fact]
    public void The_headset_turns_the_head_of_a_character_whose_driver_finds_its_Animator()
    {
        Read("VrHead").Build();
        HeadsetHead sample = Find<HeadsetHead>();
        TestFigure figure = TestFigure.Build("Ann");
        HumanoidDriver driver = figure.Drive(Find<MocapSource>());
        sample.Driver = driver;
        Find<MouseLook>().Turn(30, -20);
        _loop.RunUntil(() => driver.IsDriving);
        _loop.Frame();

        Assert.Same(figure[Bone.Head], sample.Head);
        Vector3 eyes = sample.Head!.position + (sample.Headset!.rotation * new Vector3(0, 0.09f, 0.13f));
        Assert.True((sample.Headset.position - eyes).magnitude < 1e-3f);
    }

    [Fact]
    public void The_headset_turns_the_head_and_the_suit_moves_the_body()
    {
        Read("VrHead").Build();
        HeadsetHead sample = Find<HeadsetHead>();
        Transform headset = sample.Headset!;
        FigureBuilder builder = Find<FigureBuilder>();
        Moves(() => builder.Figure);

        // The suit's own head turns independently.
        Find<MouseLook>().Turn(30, -20);
        _loop.Frames(10);
        Assert.True(Quaternion.Angle(sample.Head!.rotation, headset.rotation) < 0.1f);
        Assert.True(((Quaternion.Euler(-20, 30, 0) * Vector3.forward) - headset.forward).magnitude < 1e-5f);
        Vector3 eyes = sample.Head.position + (headset.rotation * new Vector3(0, 0.09f, 0.13f));
        Assert.True((headset.position - eyes).magnitude < 1e-3f);

        sample.Recenter();
        Vector3 chest = builder.Figure!.GetBone(Bone.Spine2).forward;
        Assert.True(Vector3.Angle(Vector3.ProjectOnPlane(headset.forward, Vector3.up), Vector3.ProjectOnPlane(chest, Vector3.up)) < 3);

        // The suit controls the head again.
        sample.enabled = false;
        Assert.Equal(1, sample.Driver!.PartWeights.Get(Retargeting.BodyParts.Head));
        sample.Driver.PartWeights.Set(Retargeting.BodyParts.Head, 0.5f);
        sample.enabled = true;
        Assert.Equal(0, sample.Driver.PartWeights.Get(Retargeting.BodyParts.Head));
        sample.enabled = false;
        Assert.Equal(0.5f, sample.Driver.PartWeights.Get(Retargeting.BodyParts.Head));
    }

    [Fact]
    public void A_recording_is_played_on_the_second_figure()
    {
        Read("RecordAndPlayBack").Build();
        TakeDesk desk = Find<TakeDesk>();
        desk.RecordAtStart = 1;
        desk.Recorder!.Folder = Directory.CreateTempSubdirectory("desk").FullName;
        try
        {
            FigureBuilder second = World.Objects.OfType<FigureBuilder>().Single(static builder => builder.name == "Playback figure");
            Assert.False(desk.Playback!.enabled);

            _loop.RunUntil(() => desk.Take.Length > 0 && second.Driver.IsDriving);
            Moves(() => second.Figure);
            Assert.True(Measure.Field(desk.Playback, "_file") is string file && File.Exists(file));

            Click(desk, "Record (key R)");
            Assert.Equal(RecorderState.Recording, desk.Recorder.State);
            _loop.RunUntil(() => desk.Recorder.Frames > 5);
            Assert.Contains(Shown(desk), static text => text.Contains("frames", StringComparison.Ordinal));
            string before = desk.Take;
            Click(desk, "Stop and play (key R)");
            _loop.RunUntil(() => desk.Take != before);
        }
        finally
        {
            _loop.Dispose();
            Directory.Delete(desk.Recorder.Folder, recursive: true);
        }
    }

    [Fact]
    public void Feet_paint_tiles_and_hands_burst_balloons()
    {
        Read("Scripting").Build();
        TileGame game = Find<TileGame>();

        // A performer who stands has painted a tile. A performer who walks paints more.
        _loop.RunUntil(() => game.PaintedTiles >= 4);
        Assert.NotEqual(Vector3.zero, game.BalloonPosition);

        Transform balloon = World.Objects.OfType<GameObject>().Single(static item => item.name == "Balloon").transform;
        Performer performer = game.Source!.Performers[0];
        int before = game.Balloons;
        balloon.localPosition = performer.GetPosition(Bone.LeftHand);
        game.Play(performer);
        Assert.Equal(before + 1, game.Balloons);
        Assert.NotEqual(performer.GetPosition(Bone.LeftHand), balloon.localPosition);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Tiles_have_a_material_of_the_render_pipeline(bool hasPipeline)
    {
        const string lit = "Universal Render Pipeline/Lit";
        Shader.Available.Add(lit);
        GraphicsSettings.currentRenderPipeline = hasPipeline ? ScriptableObject.CreateInstance<LitPipeline>() : null;
        try
        {
            Read("Scripting").Build();
            _loop.Frame();
            Renderer[] tiles = Find<TileGame>().GetComponentsInChildren<Renderer>();
            Assert.NotEmpty(tiles);
            Assert.All(tiles, tile => Assert.Equal(hasPipeline ? lit : "Standard", tile.sharedMaterial!.shader.name));
        }
        finally
        {
            GraphicsSettings.currentRenderPipeline = null;
            Shader.Available.Remove(lit);
        }
    }

    private static SceneFile Read(string sample) => SceneFile.Read(Path.Combine(Folder, sample, sample + ".unity"));

    private static T Find<T>()
        where T : Component => World.Objects.OfType<T>().Single();

    private static void Click(MonoBehaviour script, string label) => ImmediateGui.Click(() => script.State.Call("OnGUI"), label);

    private static string[] Shown(MonoBehaviour script)
    {
        ImmediateGui.Draw(() => script.State.Call("OnGUI"));
        return [.. ImmediateGui.Controls.Select(static control => control.Label)];
    }

    private void Moves(Func<HumanoidFigure?> figure)
    {
        _loop.RunUntil(() => figure() is { IsDestroyed: false });
        Quaternion start = figure()!.GetBone(Bone.LeftUpLeg).localRotation;
        _loop.RunUntil(() => figure() is { IsDestroyed: false } shown && Quaternion.Angle(shown.GetBone(Bone.LeftUpLeg).localRotation, start) > 3);
        Assert.DoesNotContain(ConsoleLog.Entries, static entry => entry.Type is LogType.Error or LogType.Exception);
    }

    private sealed class LitPipeline : RenderPipelineAsset
    {
        public override Shader? defaultShader => Shader.Find("Universal Render Pipeline/Lit");
    }

    private static class HumanoidFigureSizes
    {
        public static SkeletonBody Tall => SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure() with { UpperLeg = 0.47f });
    }
}
