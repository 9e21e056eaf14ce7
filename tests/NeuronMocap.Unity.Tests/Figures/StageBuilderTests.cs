using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity.Tests.Figures;

public sealed class StageBuilderTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void The_camera_goes_along_with_a_built_figure_whose_object_stays_where_it_is()
    {
        FigureBuilder builder = new GameObject("Figure").AddComponent<FigureBuilder>();
        StageBuilder stage = new GameObject("Stage").AddComponent<StageBuilder>();
        stage.Target = builder.transform;
        _loop.Frame();

        Transform hips = builder.Figure!.GetBone(Bone.Hips);
        hips.position = new Vector3(4, 0.9f, -3);
        _loop.RunFor(2);

        Transform camera = stage.Camera!.transform;
        Assert.True(Vector3.Angle(camera.forward, hips.position - camera.position) < 3);
        Assert.True((camera.position - (hips.position + stage.Viewpoint)).magnitude < 0.2f);
    }
}
