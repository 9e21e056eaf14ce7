using NeuronMocap.Unity.EditorTools;
using UnityEditor;
using UnityEditor.Build.Reporting;
using UnityEngine.Rendering;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.Tests.Editor;

/// <summary>What a build adds to its scenes, so that players can draw built figures and grounds.</summary>
public sealed class BuildMaterialTests : IDisposable
{
    private readonly EditorWorld _world = new();
    private readonly Material _lit = new(Shader.Find("Standard")!);

    public void Dispose()
    {
        GraphicsSettings.currentRenderPipeline = null;
        _world.Dispose();
    }

    [Fact]
    public void Components_of_a_scene_get_the_material_of_the_pipeline()
    {
        UsePipeline(_lit);
        var (figure, spawner, stage) = AddComponents();
        figure.gameObject.SetActive(false);
        Process(BuildReport.Of(BuildTarget.StandaloneWindows64));

        Assert.Same(_lit, figure.Look.Material);
        Assert.Same(_lit, spawner.Material);
        Assert.Same(_lit, stage.GroundMaterial);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void A_material_of_the_user_stays()
    {
        UsePipeline(_lit);
        var (figure, spawner, stage) = AddComponents();
        var own = new Material(_lit);
        (figure.Look.Material, spawner.Material, stage.GroundMaterial) = (own, own, own);
        Process(BuildReport.Of(BuildTarget.StandaloneWindows64));

        Assert.All((Material?[])[figure.Look.Material, spawner.Material, stage.GroundMaterial], shown => Assert.Same(own, shown));
    }

    [Theory]
    [InlineData(true, false)]
    [InlineData(false, true)]
    public void Play_mode_and_the_built_in_pipeline_need_none(bool hasPipeline, bool isBuild)
    {
        if (hasPipeline)
            UsePipeline(_lit);

        var (figure, spawner, stage) = AddComponents();
        Process(isBuild ? BuildReport.Of(BuildTarget.StandaloneWindows64) : null);

        Assert.All((Material?[])[figure.Look.Material, spawner.Material, stage.GroundMaterial], Assert.Null);
    }

    private static (FigureBuilder Figure, PerformerSpawner Spawner, StageBuilder Stage) AddComponents() => (
        new GameObject("Figure").AddComponent<FigureBuilder>(),
        new GameObject("Spawner").AddComponent<PerformerSpawner>(),
        new GameObject("Stage").AddComponent<StageBuilder>());

    private static void UsePipeline(Material material)
    {
        LitPipeline pipeline = ScriptableObject.CreateInstance<LitPipeline>();
        pipeline.Lit = material;
        GraphicsSettings.currentRenderPipeline = pipeline;
    }

    private static void Process(BuildReport? report) => new BuildChecks().OnProcessScene(SceneManager.GetActiveScene(), report);

    private sealed class LitPipeline : RenderPipelineAsset
    {
        public Material? Lit { get; set; }

        public override Material? defaultMaterial => Lit;
    }
}
