using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Figures.Pictures;

/// <summary>
/// Draws the figure of Quick start: its real mesh, in poses of the simulator that came over loopback and through a driver.
/// NEURONMOCAP_UPDATE_PICTURES=1 rewrites the file.
/// </summary>
public sealed class FigurePictureTests : IDisposable
{
    private const int Width = 1200;
    private const int Height = 520;
    private const float PixelsPerMetre = 265;

    // The position of the eye, in degrees around the figure from its front.
    private static readonly (double Seconds, float Degrees, int X)[] Views = [(-1, -15, 250), (2, 35, 580), (5, -20, 830), (8, 150, 1070)];

    private static readonly string Picture = Path.Combine(Repository.Root, "unity-package", "Documentation~", "images", "figure.png");

    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void The_documented_picture_matches_the_figure()
    {
        var canvas = new FigureCanvas(Width, Height);
        using Broadcaster server = Stage.Broadcast([.. Views.Select(static view => new StillActor(view.Seconds))]);
        MocapSource source = Stage.AddClient(server);
        FigureBuilder[] builders = [.. Views.Select((_, i) => AddFigure(source, i))];
        _loop.RunUntil(() => Stage.IsLive(source, Views.Length) && builders.All(static builder => builder.Driver.IsDriving));
        _loop.RunFor(0.3f);

        for (int i = 0; i < builders.Length; i++)
        {
            HumanoidFigure figure = builders[i].Figure!;
            Transform hips = figure.GetBone(Bone.Hips);
            Vector3 front = Vector3.ProjectOnPlane(hips.forward, Vector3.up).normalized;
            Vector3 view = (Quaternion.Euler(0, Views[i].Degrees, 0) * front) + (0.16f * Vector3.up);
            Vector3 ground = Vector3.ProjectOnPlane(hips.position, Vector3.up);
            canvas.Draw(figure.Renderer, ground, view, new Vector2(Views[i].X, Height - 45), PixelsPerMetre);
        }

        Compare(canvas);
    }

    private static FigureBuilder AddFigure(MocapSource source, int performer)
    {
        var holder = new GameObject("Performer " + performer);
        holder.SetActive(false);
        FigureBuilder builder = holder.AddComponent<FigureBuilder>();
        HumanoidDriver driver = holder.GetComponent<HumanoidDriver>();
        driver.Source = source;
        driver.PerformerIndex = performer;
        holder.SetActive(true);
        return builder;
    }

    private static void Compare(FigureCanvas canvas)
    {
        byte[] drawn = canvas.ToPixels();
        if (Environment.GetEnvironmentVariable("NEURONMOCAP_UPDATE_PICTURES") == "1")
            PngFile.Write(Picture, canvas.Width, canvas.Height, drawn);

        byte[] kept = PngFile.Read(Picture, out int width, out int height);
        Assert.Equal((canvas.Width, canvas.Height), (width, height));

        // Edges may differ slightly on another processor. A changed shape differs more.
        int different = drawn.Zip(kept).Count(static pair => Math.Abs(pair.First - pair.Second) > 24);
        Assert.True(different < drawn.Length / 1000, $"{different} of {drawn.Length} values differ: check the figure, and write the picture again.");
    }

    // A fixed moment of the simulator's programme. Before the programme starts, it is the T-pose.
    private sealed class StillActor(double seconds) : MotionSource
    {
        private readonly SyntheticSource _actor = new();

        public override double FrameRate => 100;

        public override long? FrameCount => null;

        public override bool HasDisplacement => true;

        public override void GetPose(long frame, Span<BoneTransform> pose)
        {
            if (seconds < 0)
                SkeletonBody.GetDefault().CopyRestPose(pose);
            else
                _actor.GetPose((long)(seconds * _actor.FrameRate), pose);
        }

        public override FootContacts GetFootContacts(long frame) => default;
    }
}
