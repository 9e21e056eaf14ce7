using System.Text;
using System.Text.Json;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Commands;

public sealed class CommandRunTests : IDisposable
{
    private readonly Broadcaster _broadcaster = new(new BroadcasterOptions
    {
        Sources = [new SyntheticSource(), new SyntheticSource(avatarIndex: 1)],
        RotationOrder = RotationOrder.ZXY,
        Port = 0,
    });

    [Fact]
    public async Task The_report_has_sizes_order_and_header()
    {
        using CommandServer server = Start();
        ToolResult result = await ToolRunner.RunAsync("command", AddressOf(server), "--avatar", "1");

        Assert.Equal(0, result.ExitCode);
        Assert.Empty(result.Error);
        Assert.Equal($"Command channel of {AddressOf(server)}", result.Output[0]);
        Assert.Equal("Rotation order     ZXY", result.Output[1]);
        Assert.Equal("Bone sizes of avatar 1, in metres", result.Output[2]);
        Assert.Equal("  head              0.170    palm          0.084", result.Output[3]);
        Assert.Equal("  forearm           0.250    foot length   0.158", result.Output[8]);
        Assert.StartsWith("BVH header of avatar 1, ", result.Output[9], StringComparison.Ordinal);
        Assert.Equal(
            ["  59 joints from Hips, 354 values a frame", "  displacement on, reference off, bone names Neck1", "  rotation order ZXY", "  hips 84.1 cm above the ground"],
            result.Output[10..]);
    }

    [Fact]
    public async Task The_local_address_is_used_and_named_if_it_does_not_fit()
    {
        using CommandServer server = Start();
        Assert.Equal(["ZXY"], (await ToolRunner.RunAsync("command", AddressOf(server), "order", "--local-address", "127.0.0.1")).Output);

        ToolResult result = await ToolRunner.RunAsync("command", AddressOf(server), "order", "--local-address", "::1");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("The local address ::1 does not belong to this computer", string.Join(' ', result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Json_has_everything_in_one_object()
    {
        using CommandServer server = Start();
        ToolResult result = await ToolRunner.RunAsync("command", AddressOf(server), "--json");

        Assert.Equal(0, result.ExitCode);
        JsonElement answer = JsonDocument.Parse(Assert.Single(result.OfType("commands"))).RootElement;
        Assert.Equal("ZXY", answer.GetProperty("rotationOrder").GetString());
        Assert.Equal(0, answer.GetProperty("avatar").GetInt32());
        Assert.Equal(0.28, answer.GetProperty("boneSizes").GetProperty("shoulderWidth").GetDouble(), 1e-6);
        Assert.Equal(12, answer.GetProperty("boneSizes").EnumerateObject().Count());
        BvhDocument header = BvhDocument.Parse(Encoding.UTF8.GetBytes(answer.GetProperty("bvhHeader").GetString()!));
        Assert.Equal(59, header.Joints.Count);
    }

    [Theory]
    [InlineData("order", "rotationOrder")]
    [InlineData("bones", "boneSizes")]
    [InlineData("header", "bvhHeader")]
    public async Task One_question_has_one_answer(string question, string field)
    {
        using CommandServer server = Start();
        bool isOfServer = question is "order";
        ToolResult result = await ToolRunner.RunAsync(["command", AddressOf(server), question, "--json", .. isOfServer ? (string[])[] : ["--avatar", "1"]]);

        Assert.Equal(0, result.ExitCode);
        JsonElement answer = JsonDocument.Parse(Assert.Single(result.Output)).RootElement;
        Assert.Equal(isOfServer ? 0 : 1, answer.GetProperty("avatar").GetInt32());
        foreach (string other in (string[])["rotationOrder", "boneSizes", "bvhHeader"])
            Assert.Equal(other != field, answer.GetProperty(other).ValueKind == JsonValueKind.Null);
    }

    [Fact]
    public async Task The_order_alone_is_a_word_and_the_sizes_alone_are_a_table()
    {
        using CommandServer server = Start();
        Assert.Equal("ZXY", Assert.Single((await ToolRunner.RunAsync("command", $"tcp://{AddressOf(server)}", "order")).Output));
        string[] sizes = (await ToolRunner.RunAsync("command", AddressOf(server), "bones", "--avatar", "1")).Output;
        Assert.Equal(8, sizes.Length);
        Assert.Equal("  head              0.170    palm          0.084", sizes[2]);
    }

    [Fact]
    public async Task The_header_can_be_written_to_a_file()
    {
        using CommandServer server = Start();
        using var output = new MemoryStream();
        await ToolRunner.RunAsync(output, ["command", AddressOf(server), "header"]);

        Assert.Equal(59, BvhDocument.Parse(output.ToArray()).Joints.Count);
        Assert.StartsWith("HIERARCHY\r\nROOT Hips\r\n", Encoding.UTF8.GetString(output.ToArray()), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("Avatar 1 of ", "1", "--avatar", "1")]
    [InlineData("All avatars of ", "\"all\"")]
    public async Task A_zero_out_is_done_and_confirmed(string told, string target, params string[] args)
    {
        using CommandServer server = Start();
        ToolResult result = await ToolRunner.RunAsync(["command", AddressOf(server), "zero-out", .. args]);
        Assert.Equal(0, result.ExitCode);
        Assert.StartsWith(told, Assert.Single(result.Output), StringComparison.Ordinal);

        ToolResult json = await ToolRunner.RunAsync(["command", AddressOf(server), "zero-out", .. args, "--json"]);
        Assert.Contains($"\"avatar\":{target}", Assert.Single(json.OfType("zeroOut")), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("avatar 9", "--avatar", "9")]
    [InlineData("avatar 9", "zero-out", "--avatar", "9")]
    [InlineData("avatar 9", "bones", "--avatar", "9")]
    [InlineData("avatar 9", "header", "--avatar", "9")]
    public async Task A_missing_answer_ends_with_1_and_one_line(string told, params string[] args)
    {
        using CommandServer server = Start();
        ToolResult result = await ToolRunner.RunAsync(["command", AddressOf(server), .. args]);
        Assert.Equal(1, result.ExitCode);
        Assert.Contains(told, Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_refused_connection_ends_with_1_and_one_line()
    {
        ToolResult result = await ToolRunner.RunAsync("command", FrameServer.RefusingAddress());
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("refused the connection", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_demo_has_a_command_channel_too()
    {
        ToolResult result = await ToolRunner.RunAsync("command", "demo");
        Assert.Equal(0, result.ExitCode);
        Assert.Contains("Rotation order     YXZ", result.Output);
    }

    public void Dispose() => _broadcaster.Dispose();

    private static string AddressOf(CommandServer server) => $"127.0.0.1:{server.LocalEndPoint!.Port}";

    private CommandServer Start()
    {
        var server = new CommandServer(_broadcaster, new CommandServerOptions { Port = 0 });
        server.Start();
        return server;
    }
}
