using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.DebugViews;

public sealed class PerformerOverlayTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Each_performer_has_a_line_with_rate_and_delay()
    {
        MocapSource source = Stage.AddSimulator(performers: 2);
        source.Delay = 45;
        PerformerOverlay overlay = new GameObject("Overlay").AddComponent<PerformerOverlay>();
        overlay.Interval = 0.1f;
        _loop.RunUntil(() => Stage.IsLive(source, performers: 2) && source.Performers.All(static performer => performer.FrameRate > 0));
        _loop.RunUntil(() => overlay.Lines.Count == 2 && overlay.Lines.All(static line => line.Contains("delay", StringComparison.Ordinal)));

        Draw(overlay);

        string[] labels = [.. ImmediateGui.Controls.Select(static control => control.Label)];
        Assert.Equal(overlay.Lines, labels);
        Assert.Matches(@"^Char00 \(0\): \d+\.\d /s, delay \d+\.\d ms, jitter \d+\.\d ms, \d+ late$", labels[0]);
        Assert.StartsWith("Char01 (1): ", labels[1], StringComparison.Ordinal);
        Assert.True(source.Performers[0].Latency >= 0.045f, $"{source.Performers[0].Latency}");

        // On a busy machine, the first frames can arrive together.
        _loop.RunUntil(() => source.Performers[0].NeededDelay >= 1 / 70f);
    }

    [Fact]
    public void Several_sources_are_listed_with_their_names()
    {
        MocapSource left = Stage.AddSimulator();
        MocapSource right = Stage.AddSimulator(performers: 2);
        (left.name, right.name) = ("Left", "Right");
        PerformerOverlay overlay = new GameObject("Overlay").AddComponent<PerformerOverlay>();
        overlay.Interval = 0.1f;

        // A source without a frame has one line with its status, on a busy machine even when the other has both performers.
        _loop.RunUntil(() => overlay.Lines.Count == 3 && overlay.Lines.All(static line => line.Contains("delay", StringComparison.Ordinal)));

        Assert.StartsWith("Left: Char00 (0): ", overlay.Lines[0], StringComparison.Ordinal);
        Assert.StartsWith("Right: Char00 (0): ", overlay.Lines[1], StringComparison.Ordinal);
        Assert.StartsWith("Right: Char01 (1): ", overlay.Lines[2], StringComparison.Ordinal);
    }

    [Fact]
    public void Without_performers_the_status_is_shown_and_without_a_source_nothing()
    {
        PerformerOverlay overlay = new GameObject("Overlay").AddComponent<PerformerOverlay>();
        _loop.Frame();
        Draw(overlay);
        Assert.Empty(ImmediateGui.Controls);

        MocapSource source = Stage.AddSimulator();
        overlay.Source = source;
        source.Close();
        _loop.Frame(1);
        Assert.Equal([source.StatusMessage], overlay.Lines);

        overlay.enabled = false;
        Assert.Empty(overlay.Lines);
    }

    [Fact]
    public void Frames_between_two_updates_allocate_nothing()
    {
        MocapSource source = Stage.AddSimulator();
        PerformerOverlay overlay = new GameObject("Overlay").AddComponent<PerformerOverlay>();
        overlay.Interval = 5;
        _loop.RunUntil(() => Stage.IsLive(source));

        Assert.Equal(0, Measure.BytesPerFrame(_loop, overlay, "Update"));
    }

    private static void Draw(MonoBehaviour script) => ImmediateGui.Draw(() => script.State.Call("OnGUI"));
}
