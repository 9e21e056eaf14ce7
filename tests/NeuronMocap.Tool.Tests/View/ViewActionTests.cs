using System.Text.Json;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Tool.Tests.Files;

namespace NeuronMocap.Tool.Tests.View;

// The buttons of the panel.
public sealed class ViewActionTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task A_recording_starts_and_stops_for_all_pages()
    {
        await using (RunningView view = await RunningView.StartAsync("demo", "--record-folder", _folder[string.Empty]))
        {
            using ViewSocket control = await view.ConnectAsync("/control");
            Assert.Equal("idle", (await control.FindAsync("recording")).GetProperty("state").GetString());
            (int status, JsonElement answer) = await view.PostAsync("/api/record", """{"action":"start"}""");
            Assert.Equal(200, status);
            Assert.Equal("recording", answer.GetProperty("state").GetString());
            Assert.Equal(Assert.Single(_folder.Names), answer.GetProperty("file").GetString());
            await control.FindAsync("recording", static message => message.GetProperty("state").ValueEquals("recording") && message.GetProperty("bytes").GetInt64() > 0);

            // A page that comes later sees it, too.
            using ViewSocket other = await view.ConnectAsync("/control");
            Assert.Equal("recording", (await other.FindAsync("recording")).GetProperty("state").GetString());
            (status, answer) = await view.PostAsync("/api/record", """{"action":"start"}""");
            Assert.Equal((409, "A recording is running already."), (status, answer.GetProperty("error").GetString()));

            (status, answer) = await view.PostAsync("/api/record", """{"action":"stop"}""");
            Assert.Equal((200, "idle"), (status, answer.GetProperty("state").GetString()));
            await other.FindAsync("recording", static message => message.GetProperty("state").ValueEquals("idle"));

            // A page that is loaded again still lists it.
            using ViewSocket late = await view.ConnectAsync("/control");
            JsonElement finished = await late.FindAsync("recording");
            Assert.Equal(_folder.Names.Single(), finished.GetProperty("file").GetString());
            await view.GetAsync($"/api/takes/{finished.GetProperty("take").GetString()}");
            (status, answer) = await view.PostAsync("/api/record", """{"action":"stop"}""");
            Assert.Equal((409, "No recording is running."), (status, answer.GetProperty("error").GetString()));
            Assert.Equal(0, await view.StopAsync());
            Assert.Contains("neuron-mocap: recorded ", view.Error, StringComparison.Ordinal);
        }

        using RecordingReader recording = RecordingReader.Open(_folder[Assert.Single(_folder.Names)]);
        Assert.True(recording.Duration > TimeSpan.Zero);
    }

    [Fact]
    public async Task A_recording_that_runs_at_the_end_is_complete()
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--record-folder", _folder[string.Empty]);
        using ViewSocket control = await view.ConnectAsync("/control");
        await view.PostAsync("/api/record", """{"action":"start"}""");
        await control.FindAsync("recording", static message => message.GetProperty("bytes").GetInt64() > 0);
        Assert.Equal(0, await view.StopAsync());
        Assert.Contains("lost 0 pieces.", view.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_folder_that_has_gone_is_a_sentence_without_its_path()
    {
        string folder = _folder["takes"];
        Directory.CreateDirectory(folder);
        await using RunningView view = await RunningView.StartAsync("demo", "--record-folder", folder);
        Directory.Delete(folder);
        (int status, JsonElement answer) = await view.PostAsync("/api/record", """{"action":"start"}""");
        Assert.Equal(409, status);
        Assert.StartsWith("Recording failed: ", answer.GetProperty("error").GetString(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("", "The body of the request is not the JSON that this address expects.")]
    [InlineData("null", "The body of the request is empty.")]
    [InlineData("[]", "The body of the request is not the JSON that this address expects.")]
    [InlineData("{}", "The action of a recording is start or stop.")]
    [InlineData("""{"action":"dance"}""", "The action of a recording is start or stop.")]
    public async Task A_wrong_request_is_a_sentence(string body, string expected)
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        (int status, JsonElement answer) = await view.PostAsync("/api/record", body);
        Assert.Equal((400, expected), (status, answer.GetProperty("error").GetString()));
    }

    [Fact]
    public async Task A_diagnosis_says_what_arrives()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        JsonElement answer = default;

        // A busy computer sends and takes fewer frames, which the diagnosis rightly says. One of several is enough.
        for (int tries = 0; tries < 20 && (tries == 0 || answer.GetProperty("verdict").GetString() is "LowRate"); tries++)
        {
            (int status, answer) = await view.PostAsync("/api/diagnose");
            Assert.Equal(200, status);
        }

        Assert.Equal("Receiving", answer.GetProperty("verdict").GetString());
        Assert.True(answer.GetProperty("receiving").GetBoolean());
        Assert.Contains(answer.GetProperty("lines").EnumerateArray(), static line => line.GetString()!.StartsWith("ok: token: ", StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_port_that_only_one_program_can_have_is_described_from_what_is_known()
    {
        await using RunningView view = await RunningView.StartAsync($"udp://127.0.0.1:{NeuronMocap.Tests.Network.FreePort.Next()}");
        (int status, JsonElement answer) = await view.PostAsync("/api/diagnose");
        Assert.Equal(200, status);
        Assert.False(answer.GetProperty("receiving").GetBoolean());
        Assert.NotEmpty(answer.GetProperty("lines").EnumerateArray());
    }

    [Fact]
    public async Task Zero_out_reaches_the_command_channel()
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo(avatars: 2);
        await using var commands = new CommandServer(broadcaster, new CommandServerOptions { Port = 0 });
        commands.Start();
        await using RunningView view = await RunningView.StartAsync(broadcaster.LocalEndPoint!.ToString(), "--command-port", $"{commands.LocalEndPoint!.Port}");
        Assert.True((await view.GetAsync("/api/hello")).GetProperty("canCommand").GetBoolean());
        foreach (string body in (string[])["", "{}", """{"avatar":null}""", """{"avatar":1}"""])
        {
            (int status, JsonElement answer) = await view.PostAsync("/api/zero-out", body);
            Assert.Equal(200, status);
            Assert.True(answer.GetProperty("done").GetBoolean());
        }

        Assert.Equal(502, (await view.PostAsync("/api/zero-out", """{"avatar":7}""")).Status);
        Assert.Equal(400, (await view.PostAsync("/api/zero-out", """{"avatar":-1}""")).Status);
        Assert.Equal(400, (await view.PostAsync("/api/zero-out", """{"avatar":"all"}""")).Status);
    }

    [Fact]
    public async Task Without_a_command_channel_zero_out_names_the_option()
    {
        await using RunningView view = await RunningView.StartAsync($"127.0.0.1:{NeuronMocap.Tests.Network.FreePort.Next()}");
        (int status, JsonElement answer) = await view.PostAsync("/api/zero-out");
        Assert.Equal(409, status);
        Assert.Contains("--command-port", answer.GetProperty("error").GetString(), StringComparison.Ordinal);
        Assert.False((await view.GetAsync("/api/hello")).GetProperty("canCommand").GetBoolean());
    }
}
