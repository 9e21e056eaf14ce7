using NeuronMocap.Skeleton;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

public sealed class SourcesWindowTests : IDisposable
{
    private readonly EditorWorld _world = new(play: true);
    private readonly SourcesWindow _window;
    private readonly Action _draw;

    public SourcesWindowTests()
    {
        _window = SourcesWindow.Open();
        _draw = (Action)Delegate.CreateDelegate(typeof(Action), _window, "OnGUI");
    }

    public void Dispose()
    {
        _window.Close();
        _world.Dispose();
    }

    [Fact]
    public void A_missing_source_is_explained()
    {
        ImmediateGui.Draw(_draw);

        Assert.Contains("GameObject > NeuronMocap > Source", Assert.Single(EditorWorld.Labels("HelpBox")), StringComparison.Ordinal);
        Assert.Empty(ImmediateGui.Lines);
    }

    [Fact]
    public void The_window_lists_performers_and_draws_the_selected_one()
    {
        MocapSource source = AddSimulator(performers: 2);
        Performer second = source.Performers.Single(static performer => performer.AvatarIndex == 1);

        ImmediateGui.Click(_draw, $"{second.Name} (1)");
        ImmediateGui.Draw(_draw);

        Assert.Same(second, _window.Shown);
        Assert.Equal(["on"], EditorWorld.Controls.Where(control => control.Kind == "Toggle" && control.Label == $"{second.Name} (1)").Select(static control => control.Value));
        GuiLine[] bones = [.. ImmediateGui.Lines.Where(static line => line.Width > 1)];
        Assert.Equal(58 + JointPositions.EndSiteCount, bones.Length);

        // Seen from the front: right is -X, up is Y. The middle is the position of the hips at 0.95 m.
        _window.Preview.View.LookFromFront();
        ImmediateGui.Draw(_draw);
        Rect rect = ImmediateGui.FreeRect;
        Vector3 hips = second.GetPosition(Bone.Hips);
        Vector3 head = second.GetPosition(Bone.Head);
        float scale = rect.height / _window.Preview.View.Height;
        var expected = new Vector2(rect.center.x - ((head.x - hips.x) * scale), rect.center.y - ((head.y - 0.95f) * scale));
        Assert.Contains(ImmediateGui.Lines, line => (line.To - expected).magnitude < 0.01f);
    }

    [Fact]
    public void Dragging_turns_the_figure_and_the_buttons_turn_it_back()
    {
        AddSimulator(performers: 1);
        PreviewView view = _window.Preview.View;
        ImmediateGui.Send(_draw, new Event { type = EventType.MouseDrag, mousePosition = ImmediateGui.FreeRect.center, delta = new Vector2(40, 0) });
        Assert.Equal(20, view.Yaw, 1e-4f);

        ImmediateGui.Click(_draw, "Side");
        Assert.Equal((90f, 0f), (view.Yaw, view.Pitch));
        ImmediateGui.Click(_draw, "Front");
        Assert.Equal((0f, 0f), (view.Yaw, view.Pitch));
    }

    [Fact]
    public void The_window_repaints_ten_times_a_second()
    {
        int before = _window.Repaints;
        for (int i = 0; i < 100; i++)
            EditorApplication.Tick(0.01);

        Assert.InRange(_window.Repaints - before, 9, 11);
    }

    [Fact]
    public void A_source_without_a_command_port_cannot_be_zeroed_out()
    {
        AddSimulator(performers: 1);
        ImmediateGui.Draw(_draw);

        Assert.False(EditorWorld.Find(SourcePanel.ZeroOutAll).IsEnabled);
        Assert.True(EditorWorld.Find(SourcePanel.Record).IsEnabled);
    }

    private MocapSource AddSimulator(int performers)
    {
        MocapSource source = _world.AddSource(source => (source.Kind, source.PerformerCount) = (SourceKind.Simulator, performers), "Stage");
        EditorApplication.RaiseHierarchyChanged();
        _world.Loop.RunUntil(() => source.Performers.Count == performers && source.Performers.All(static performer => performer.HasPose));
        return source;
    }
}
