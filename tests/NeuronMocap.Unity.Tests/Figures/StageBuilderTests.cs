namespace NeuronMocap.Unity.Tests.Figures;

public sealed class StageBuilderTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Its_object_may_be_deactivated_and_activated()
    {
        var holder = new GameObject("Stage");
        holder.AddComponent<StageBuilder>();
        for (int i = 0; i < 3; i++)
        {
            _loop.Frame();
            Assert.Equal(1, holder.transform.childCount);
            Assert.NotNull(holder.GetComponentInChildren<Light>());
            holder.SetActive(false);
            _loop.Frame();
            Assert.Equal(0, holder.transform.childCount);
            holder.SetActive(true);
        }

        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void The_camera_follows_in_a_paused_game()
    {
        var target = new GameObject("Target").transform;
        var stage = new GameObject("Stage").AddComponent<StageBuilder>();
        stage.Target = target;
        _loop.Frame();
        Time.timeScale = 0;
        target.position = new Vector3(5, 0, 0);
        _loop.Frames(180);

        Vector3 wanted = target.position + stage.Viewpoint;
        Assert.True((stage.Camera!.transform.position - wanted).magnitude < 0.05f);
    }

    [Fact]
    public void The_camera_follows_a_built_figure()
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
