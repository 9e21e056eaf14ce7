using NeuronMocap.Diagnostics;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

public class DiagnosisTests
{
    [Fact]
    public async Task The_button_reports_a_refused_connection()
    {
        using var world = new EditorWorld();
        using (var server = new TestServer())
            world.AddSource(source => source.Port = server.Port);

        await AskAsync(world);

        Assert.Equal(ReportGui.ColorOf(Severity.Error, isDarkSkin: true), EditorWorld.DotOf("Nothing listens on this port"));
        Assert.Contains("refuses the connection", EditorWorld.Controls.Last(static control => control.Kind == "HelpBox").Label, StringComparison.Ordinal);
        Assert.NotEqual(0, EditorWorld.Controls.Count(static control => control.Label == "port"));
    }

    [Fact]
    public async Task The_button_reports_a_silent_server()
    {
        using var world = new EditorWorld();
        using var server = new TestServer();
        world.AddSource(source => source.Port = server.Port);

        await AskAsync(world);

        Assert.Equal(ReportGui.ColorOf(Severity.Error, isDarkSkin: true), EditorWorld.DotOf("Nothing arrives"));
    }

    [Fact]
    public async Task The_button_reports_another_program()
    {
        using var world = new EditorWorld();
        DiagnosisPanel.Options = new DiagnosisOptions { Timeout = TimeSpan.FromSeconds(10), SearchOtherPorts = false };
        using var server = new TestServer();
        world.AddSource(source => source.Port = server.Port);
        Task greeting = GreetAsync(server, "SSH-2.0-OpenSSH_9.6\r\n"u8.ToArray());

        await AskAsync(world);

        Assert.Equal(ReportGui.ColorOf(Severity.Error, isDarkSkin: true), EditorWorld.DotOf("Another program"));
        await greeting;
    }

    [Fact]
    public async Task The_button_reports_arriving_frames()
    {
        using var world = new EditorWorld();
        DiagnosisPanel.Options = new DiagnosisOptions { Timeout = TimeSpan.FromSeconds(10), SearchOtherPorts = false };
        using var server = new Server.Broadcaster(new Server.BroadcasterOptions { Port = 0, Sources = [new Server.SyntheticSource(60, 0)] });
        server.Start();
        world.AddSource(source => source.Port = server.LocalEndPoint!.Port);

        await AskAsync(world);

        // A second is too short to measure a rate of 60 with certainty. With few frames, the diagnosis says so.
        Assert.Contains(EditorWorld.Controls, static control => control.Label.StartsWith("Frames arrive", StringComparison.Ordinal));
        Assert.DoesNotContain(EditorWorld.Controls, static control => control.Kind == "HelpBox" && control.Value == "Error");
    }

    [Fact]
    public async Task A_diagnosis_can_be_cancelled_and_repeated()
    {
        using var world = new EditorWorld();
        using var server = new TestServer();
        MocapSource source = world.AddSource(source => source.Port = server.Port);
        DiagnosisPanel.Options = new DiagnosisOptions { Timeout = TimeSpan.FromMinutes(5), SearchOtherPorts = false };
        var inspector = (MocapSourceEditor)world.Inspect(source);

        ImmediateGui.Click(inspector.OnInspectorGUI, DiagnosisPanel.Ask);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.False(EditorWorld.Find(DiagnosisPanel.Ask).IsEnabled);
        ImmediateGui.Click(inspector.OnInspectorGUI, DiagnosisPanel.Cancel);
        await inspector.Diagnosis.Job!.Completion.Soon();
        MainThread.Claim();

        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Contains("Cancelled", EditorWorld.Labels("Label"));
        Assert.True(EditorWorld.Find(DiagnosisPanel.Ask).IsEnabled);
        Assert.DoesNotContain(DiagnosisPanel.Cancel, EditorWorld.Labels("Button"));
    }

    [Fact]
    public async Task Closing_the_inspector_ends_the_diagnosis()
    {
        using var world = new EditorWorld();
        using var server = new TestServer();
        DiagnosisPanel.Options = new DiagnosisOptions { Timeout = TimeSpan.FromMinutes(5), SearchOtherPorts = false };
        var inspector = (MocapSourceEditor)world.Inspect(world.AddSource(source => source.Port = server.Port));
        ImmediateGui.Click(inspector.OnInspectorGUI, DiagnosisPanel.Ask);

        Object.DestroyImmediate(inspector);

        await inspector.Diagnosis.Job!.Completion.Soon();
        Assert.True(inspector.Diagnosis.Job.IsCancelled);
    }

    [Fact]
    public async Task Invalid_settings_are_named()
    {
        using var world = new EditorWorld();
        world.AddSource(static source => source.Address = " ");

        await AskAsync(world);

        Assert.Contains("Host is empty", EditorWorld.Controls.Last(static control => control.Kind == "HelpBox").Label, StringComparison.Ordinal);
    }

    // In edit mode, a preview has opened it.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_source_releases_its_UDP_port_during_the_diagnosis(bool play)
    {
        using var world = new EditorWorld(play);
        int port = FreePort.Next();
        MocapSource source = world.AddSource(source => (source.Transport, source.Port) = (TransportKind.Udp, port));
        LivePreview.Start(source);
        world.Loop.RunUntil(() =>
        {
            EditorApplication.Tick(0.01);
            return source.State == SourceState.Connected;
        });
        var inspector = (MocapSourceEditor)world.Inspect(source);

        ImmediateGui.Click(inspector.OnInspectorGUI, DiagnosisPanel.Ask);
        Assert.False(source.IsOpen);
        await inspector.Diagnosis.Job!.Completion.Soon();
        MainThread.Claim();
        ImmediateGui.Draw(inspector.OnInspectorGUI);

        Assert.Equal(DiagnosisVerdict.Silent, inspector.Diagnosis.Job.Result?.Verdict);
        Assert.True(source.IsOpen);
        LivePreview.StopAll();
    }

    [Fact]
    public async Task A_preview_that_ended_during_the_diagnosis_does_not_go_on()
    {
        using var world = new EditorWorld();
        int port = FreePort.Next();
        MocapSource source = world.AddSource(source => (source.Transport, source.Port) = (TransportKind.Udp, port));
        LivePreview.Start(source);
        var inspector = (MocapSourceEditor)world.Inspect(source);

        ImmediateGui.Click(inspector.OnInspectorGUI, DiagnosisPanel.Ask);
        LivePreview.StopAll();
        await inspector.Diagnosis.Job!.Completion.Soon();
        MainThread.Claim();
        ImmediateGui.Draw(inspector.OnInspectorGUI);

        Assert.False(source.IsOpen);
    }

    // Clicks, waits like the editor, and draws the answer.
    private static async Task AskAsync(EditorWorld world)
    {
        var inspector = (MocapSourceEditor)world.Inspect(Object.FindObjectOfType<MocapSource>()!);
        ImmediateGui.Click(inspector.OnInspectorGUI, DiagnosisPanel.Ask);
        Assert.True(inspector.Diagnosis.IsDirty);
        await inspector.Diagnosis.Job!.Completion.Soon();
        MainThread.Claim();
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.False(inspector.Diagnosis.IsDirty);
    }

    private static async Task GreetAsync(TestServer server, byte[] words)
    {
        using TestConnection client = await server.AcceptAsync();
        await client.SendAsync(words);
    }
}
