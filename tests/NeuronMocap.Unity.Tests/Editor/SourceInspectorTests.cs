using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

public class SourceInspectorTests
{
    private static readonly string[] Always = ["Kind", "Resample", "Delay", "Interpolation", "Idle Timeout", "Leave Timeout", "Stage", "Recenter Key", "Persist Across Scenes"];

    [Theory]
    [InlineData(SourceKind.Network, "Address,Port,Calculation Port,Transport,Local Address,Reconnect,Command Port,Rotation Order,Skeleton Variant")]
    [InlineData(SourceKind.Simulator, "Performer Count,Motion,Simulated Frame Rate")]
    [InlineData(SourceKind.BvhFile, "File,Bvh Asset,Loop,Speed")]
    [InlineData(SourceKind.Recording, "Rotation Order,Skeleton Variant,File,Loop,Speed")]
    public void Each_kind_has_only_its_own_fields(SourceKind kind, string fields)
    {
        using var world = new EditorWorld();
        MocapSource source = world.AddSource(source => source.Kind = kind);

        ImmediateGui.Draw(world.Inspect(source).OnInspectorGUI);

        Assert.Equal(fields.Split(',').Concat(Always).Order(), EditorWorld.Labels("Property").Order());
        Assert.All(EditorWorld.Controls.Where(static control => control.Kind == "Property"), static field => Assert.NotEmpty(field.Tooltip));
        Assert.Equal(kind == SourceKind.Network, EditorWorld.Labels("Button").Contains(DiagnosisPanel.Ask));
    }

    [Fact]
    public void Choosing_a_kind_changes_the_fields_with_Undo()
    {
        using var world = new EditorWorld();
        MocapSource source = world.AddSource(static _ => { });
        UnityEditor.Editor inspector = world.Inspect(source);

        ImmediateGui.Set(inspector.OnInspectorGUI, "Kind", SourceKind.Simulator);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(SourceKind.Simulator, source.Kind);
        Assert.Contains("Performer Count", EditorWorld.Labels("Property"));

        Undo.PerformUndo();
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(SourceKind.Network, source.Kind);
        Assert.Contains("Address", EditorWorld.Labels("Property"));
    }

    [Fact]
    public void Run_In_Background_is_offered_to_a_network_source()
    {
        using var world = new EditorWorld();
        MocapSource source = world.AddSource(static source => source.Kind = SourceKind.Simulator);
        UnityEditor.Editor inspector = world.Inspect(source);
        (PlayerSettings.runInBackground, Application.runInBackground) = (false, false);
        try
        {
            ImmediateGui.Draw(inspector.OnInspectorGUI);
            Assert.DoesNotContain(BackgroundAdvice.Button, EditorWorld.Labels("Button"));

            source.Kind = SourceKind.Network;
            ImmediateGui.Click(inspector.OnInspectorGUI, BackgroundAdvice.Button);
            Assert.Equal((true, true), (PlayerSettings.runInBackground, Application.runInBackground));

            ImmediateGui.Draw(inspector.OnInspectorGUI);
            Assert.DoesNotContain(BackgroundAdvice.Button, EditorWorld.Labels("Button"));
        }
        finally
        {
            (PlayerSettings.runInBackground, Application.runInBackground) = (true, false);
        }
    }

    [Fact]
    public void A_number_is_clamped_to_its_range()
    {
        using var world = new EditorWorld();
        MocapSource source = world.AddSource(static _ => { });

        ImmediateGui.Set(world.Inspect(source).OnInspectorGUI, "Port", 70000);

        Assert.Equal(65535, source.Port);
    }

    [Fact]
    public void Common_fields_of_several_sources_change_together()
    {
        using var world = new EditorWorld();
        MocapSource network = world.AddSource(static source => source.RotationOrder = RotationOrderSetting.XYZ);
        MocapSource recording = world.AddSource(static source => source.Kind = SourceKind.Recording);
        UnityEditor.Editor inspector = world.Inspect(network, recording);

        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.DoesNotContain("Address", EditorWorld.Labels("Property"));
        Assert.DoesNotContain("File", EditorWorld.Labels("Property"));
        Assert.Equal("\u2014", EditorWorld.Find("Rotation Order").Value);

        ImmediateGui.Set(inspector.OnInspectorGUI, "Rotation Order", RotationOrderSetting.ZYX);
        Assert.Equal((RotationOrderSetting.ZYX, RotationOrderSetting.ZYX), (network.RotationOrder, recording.RotationOrder));
        Assert.Equal((SourceKind.Network, SourceKind.Recording), (network.Kind, recording.Kind));
    }

    [Fact]
    public void Edit_mode_explains_that_sources_open_in_play_mode()
    {
        using var world = new EditorWorld();
        ImmediateGui.Draw(world.Inspect(world.AddSource(static _ => { })).OnInspectorGUI);

        Assert.Contains("Not open", EditorWorld.Labels("Label"));
    }

    [Fact]
    public void A_refused_port_is_red_and_names_the_settings()
    {
        using var world = new EditorWorld(play: true);
        MocapSource source = world.AddSource(static source => source.Port = ClosedPort());
        world.Loop.RunUntil(() => source.State == SourceState.Waiting);

        ImmediateGui.Draw(world.Inspect(source).OnInspectorGUI);

        Assert.Equal(ReportGui.ColorOf(Severity.Error, isDarkSkin: true), EditorWorld.DotOf("Connection refused"));
        GuiControl advice = EditorWorld.Find("nothing listens there");
        Assert.Equal(("HelpBox", "Error"), (advice.Kind, advice.Value));
        Assert.Contains("switch BVH on, choose TCP", advice.Label, StringComparison.Ordinal);
    }

    [Fact]
    public void Arriving_data_is_green_with_rate_and_performers()
    {
        using var world = new EditorWorld(play: true);
        MocapSource source = world.AddSource(static source => (source.Kind, source.PerformerCount, source.IdleTimeout) = (SourceKind.Simulator, 2, Stage.Patience));
        world.Loop.RunUntil(() => source.State == SourceState.Receiving && source.Performers.Count == 2 && source.FrameRate > 0);
        world.Loop.RunFor(0.2f);

        ImmediateGui.Draw(world.Inspect(source).OnInspectorGUI);

        Assert.Equal(ReportGui.ColorOf(Severity.Good, isDarkSkin: true), EditorWorld.DotOf("Receiving"));
        Assert.EndsWith(" /s", EditorWorld.Controls.Single(static control => control.Label == "Frame Rate").Value, StringComparison.Ordinal);
        Assert.Equal("0", EditorWorld.Find("Lost Frames").Value);
        Assert.Matches(@"^30 ms; the stream needs \d+ ms$", EditorWorld.Controls.Single(static control => control.Kind == "Label" && control.Label == "Delay").Value);
        Assert.Matches(@"^\d+$", EditorWorld.Find("Late Frames").Value);
        foreach (Performer performer in source.Performers)
            Assert.Contains("live", EditorWorld.Find($"{performer.Name} ({performer.AvatarIndex})").Value, StringComparison.Ordinal);
    }

    [Fact]
    public void A_wrong_rotation_order_is_an_error_despite_frames()
    {
        using var server = new Broadcaster(new BroadcasterOptions
        {
            Port = 0,
            Sources = [new SyntheticSource(60, 0)],
            Format = BroadcastFormat.Studio,
            RotationOrder = RotationOrder.YXZ,
        });
        server.Start();
        using var world = new EditorWorld(play: true);
        MocapSource source = world.AddSource(source => (source.Port, source.RotationOrder) = (server.LocalEndPoint!.Port, RotationOrderSetting.XYZ));
        world.Loop.RunUntil(() => source.Reason == ConnectionReason.RotationOrderMismatch);

        ImmediateGui.Draw(world.Inspect(source).OnInspectorGUI);

        Assert.Equal(ReportGui.ColorOf(Severity.Error, isDarkSkin: true), EditorWorld.DotOf("Receiving, with another rotation order"));
        Assert.Contains(EditorWorld.Controls, static control => control.Kind == "HelpBox" && control.Value == "Error"
            && control.Label.Contains("Rotation Order", StringComparison.Ordinal));
    }

    [Fact]
    public void A_file_within_StreamingAssets_is_named_from_there()
    {
        string folder = Path.Combine(Path.GetTempPath(), "Project", "Assets", "StreamingAssets");

        Assert.Equal("takes/a.bvh", MotionFilePanel.ToFieldText(Path.Combine(folder, "takes", "a.bvh"), folder));
        Assert.Equal(Path.Combine(folder + "2", "a.bvh"), MotionFilePanel.ToFieldText(Path.Combine(folder + "2", "a.bvh"), folder));
    }

    private static int ClosedPort()
    {
        using var server = new TestServer();
        return server.Port;
    }
}
