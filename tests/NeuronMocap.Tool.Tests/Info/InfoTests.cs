using System.Text.Json;
using System.Text.Json.Nodes;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Info;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Info;

public sealed class InfoTests : InfoPages
{
    [Fact]
    public async Task Every_file_is_described_even_if_one_fails()
    {
        Takes.Actor(2).Save(Folder["a.bvh"]);
        Takes.Actor(3).Save(Folder["b.bvh"]);
        ToolResult page = await ToolRunner.RunAsync("info", Folder["a.bvh"], Folder["none.bvh"], Folder["b.bvh"]);
        Assert.Equal(1, page.ExitCode);
        Assert.Equal(["a.bvh", "b.bvh"], page.Output.Where(static line => line is "a.bvh" or "b.bvh"));
        Assert.Contains("none.bvh", Assert.Single(page.Error), StringComparison.Ordinal);

        ToolResult json = await ToolRunner.RunAsync("info", Folder["b.bvh"], Folder["a.bvh"], "--json");
        Assert.Equal(0, json.ExitCode);
        Assert.Equal(["b.bvh", "a.bvh"], json.Output.Select(static line => JsonDocument.Parse(line).RootElement.GetProperty("file").GetString()));
    }

    [Fact]
    public async Task A_redirected_page_is_plain_text()
    {
        Takes.StraightWalk(frames: 601).Save(Folder["walk.bvh"]);
        string[] page = await PageAsync("walk.bvh");

        Assert.Equal("walk.bvh", page[0]);
        Assert.StartsWith("BVH file of Neuron's 59 bones, ", page[1], StringComparison.Ordinal);
        Assert.All(page, static line => Assert.DoesNotContain('\e', line));
        Assert.Equal("10.017 s", Fact(page, "duration"));
        Assert.Equal("601", Fact(page, "frames"));
        Assert.StartsWith("60 Hz: the file says 0.016667 s, which is 1/60 s rounded", Fact(page, "frame rate"), StringComparison.Ordinal);
        Assert.Equal("YXZ", Fact(page, "rotation order"));
        Assert.Equal("25.0 cm", Fact(page, "upper arm").Trim());
        Assert.Equal("0.00 by 10.00 m: X 0.00 to 0.00, Z 0.00 to 10.00", Fact(page, "extent"));
        Assert.StartsWith("9.90 m", Fact(page, "distance walked"), StringComparison.Ordinal);
    }

    // A serial line or a plain pseudo-terminal reports 0.
    [Theory]
    [InlineData(0)]
    [InlineData(7)]
    public async Task A_terminal_of_unknown_size_is_treated_as_narrow(int columns)
    {
        Takes.StraightWalk(frames: 61).Save(Folder["walk.bvh"]);
        ToolResult result = await ToolRunner.RunOnTerminalAsync(columns, "info", Folder["walk.bvh"]);

        Assert.Equal(0, result.ExitCode);
        Assert.Contains("walk.bvh", result.Output[0], StringComparison.Ordinal);
        Assert.Contains(result.Output, static line => line.Contains("duration", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Json_is_one_object()
    {
        Takes.StraightWalk(frames: 601).Save(Folder["walk.bvh"]);
        JsonElement info = await JsonAsync("walk.bvh");

        Assert.Equal("bvh", info.GetProperty("kind").GetString());
        Assert.Equal(601, info.GetProperty("take").GetProperty("frames").GetInt32());
        Assert.Equal(60, info.GetProperty("take").GetProperty("frameRate").GetDouble());
        Assert.Equal(59, info.GetProperty("skeleton").GetProperty("joints").GetInt32());
        Assert.Equal(0.25, info.GetProperty("boneSizes").GetProperty("upperArm").GetDouble(), 1e-6);
        Assert.Equal(10, info.GetProperty("walk").GetProperty("extent").GetProperty("highestZ").GetDouble(), 1e-4);
        Assert.Equal(1, info.GetProperty("walk").GetProperty("highestSpeed").GetDouble(), 1e-3);
    }

    // Names of an avatar, a joint, a metadata key, a reason: on the terminal, none has an effect beyond its letters. JSON contains all of it.
    [Fact]
    public async Task Text_of_a_file_cannot_control_the_terminal()
    {
        const string Odd = "\e[2J\u009b31m\u202e\r";
        using (RecordingWriter writer = RecordingWriter.Create(
            Folder["odd.nmrec"], RecordingMetadata.Empty.With("key" + Odd, "value" + Odd).With(RecordingMetadata.ServerKey, "server" + Odd)))
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "local" + Odd, "remote" + Odd));
            for (uint frame = 0; frame < 20; frame++)
                writer.WriteBytes(TimeSpan.FromSeconds(frame / 60.0), 0, Packet(0, "A" + Odd, frame));

            writer.CloseConnection(TimeSpan.FromSeconds(2), 0, "gone" + Odd);
        }

        Folder.Write("odd.bvh", Takes.TwoJoints.Replace("lFoot", "lFoot" + Odd.Replace("\r", "", StringComparison.Ordinal), StringComparison.Ordinal));
        foreach (string name in (string[])["odd.nmrec", "odd.bvh"])
        {
            foreach (string line in await PageAsync(name))
                Assert.Equal(line, TerminalText.Clean(line));

            ToolResult json = await ToolRunner.RunAsync("info", Folder[name], "--json");
            Assert.Equal(json.Output[0], TerminalText.Clean(json.Output[0]));
        }

        Assert.Equal("A" + Odd, (await JsonAsync("odd.nmrec")).GetProperty("take").GetProperty("avatarName").GetString());
        ToolResult converted = await ToolRunner.RunAsync("convert", Folder["odd.nmrec"], Folder["odd.calc"]);
        Assert.Equal(Assert.Single(converted.Error), TerminalText.Clean(converted.Error[0]));
    }

    [Theory]
    [InlineData("nowhere.bvh", "nowhere.bvh")]
    [InlineData(".", "folder")]
    public async Task A_missing_file_ends_with_1(string name, string told)
    {
        ToolResult result = await ToolRunner.RunAsync("info", Folder[name]);
        Assert.Equal(1, result.ExitCode);
        Assert.Contains(told, Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public void Numbers_that_are_not_finite_are_null()
    {
        var report = new InfoReport("a", "raw", "b");
        report.Section("s", "t").Add("box", "c", "d", new JsonObject { ["low"] = double.NegativeInfinity, ["high"] = 2.5, ["all"] = new JsonArray(float.NaN, 1) });

        JsonElement section = JsonDocument.Parse(InfoJson.Write(report)).RootElement.GetProperty("s");
        Assert.Equal("""{"low":null,"high":2.5,"all":[null,1]}""", section.GetProperty("box").GetRawText());
    }
}
