using System.Globalization;
using System.Text;
using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Commands;

/// <summary>The command channel of b17 and b18, from C and C++.</summary>
public sealed class CommandChannelTests
{
    private const string Bvh = "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\n"
        + " End Site\n {\n  OFFSET 0 1 0\n }\n}\n";

    private static readonly string Printed = Bvh.Replace("\n", "\\n", StringComparison.Ordinal);

    [Theory]
    [InlineData("channel")]
    [InlineData("channel-cpp")]
    public async Task Every_command_is_answered(string name)
    {
        using CommandScript server = Answers();
        await using NativeProgram program = NativeProgram.Start(name);
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}");
        Assert.Equal("0", await program.CallAsync($"get-status {pipe}"));

        Assert.Equal("1", await program.CallAsync($"zero-out {pipe} 0"));
        Assert.Equal("0", await program.CallAsync($"zero-out {pipe} 7"));
        Assert.Equal("0", await program.CallAsync($"zero-out {pipe} -1"));
        Assert.Equal("1", await program.CallAsync($"zero-out-all {pipe}"));
        Assert.Equal("1 order 4", await program.CallAsync($"rotation {pipe}"));
        string sizes = await program.CallAsync($"bone-size {pipe} 1");
        Assert.Equal("1 0.100000001 0.200000003 0.300000012 0.400000006 0.5 0.600000024 0.699999988 0.800000012 0.899999976 1 1.10000002 1.20000005", sizes);
        Assert.Equal(sizes, await program.CallAsync($"bone-size-by-heading {pipe} 1"));

        // Languages that take a bool for an int read four bytes.
        Assert.Equal("1", await program.CallAsync($"zero-out-as-int {pipe} 0"));
        Assert.Equal("0", await program.CallAsync($"zero-out-as-int {pipe} 7"));

        Assert.Equal("closed", await program.CallAsync($"close {pipe}"));
        Assert.Equal("0", await program.CallAsync($"zero-out-as-int {pipe} 0"));
        Assert.Equal("2", await program.CallAsync($"get-status {pipe}"));
        Assert.Equal(0, await program.EndAsync());
        Assert.Empty(program.Errors);
    }

    // A zero byte follows the text where there is room, and nothing is written behind the room.
    [Fact]
    public async Task The_header_takes_the_room_that_there_is()
    {
        using CommandScript server = Answers();
        await using NativeProgram program = NativeProgram.Start("channel");
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}");

        Assert.Equal($"1 {Printed}\\0", await program.CallAsync($"header {pipe} 0 100000"));
        Assert.Equal($"1 {Printed}\\0", await program.CallAsync($"header {pipe} 0 {Bvh.Length + 1}"));
        Assert.Equal($"1 {Printed}", await program.CallAsync($"header {pipe} 0 {Bvh.Length}"));
        Assert.Equal("1 HIERARCHY", await program.CallAsync($"header {pipe} 0 9"));
        Assert.Equal("1 H", await program.CallAsync($"header {pipe} 0 1"));
        int asked = server.Requests;
        Assert.Equal("0 ", await program.CallAsync($"header {pipe} 0 0"));
        Assert.Equal("0 ", await program.CallAsync($"header {pipe} 0 -5"));
        Assert.Equal("0 0 0", await program.CallAsync($"no-room {pipe}"));
        Assert.Equal(asked, server.Requests);

        // No answer leaves the memory alone.
        Assert.Equal("0 xxxx", await program.CallAsync($"header {pipe} -1 4"));
    }

    [Fact]
    public async Task Handles_of_data_connections_and_foreign_ones_take_no_commands_and_results_are_set()
    {
        using var server = new TestServer();
        await using NativeProgram program = NativeProgram.Start("channel");
        string data = await program.CallAsync($"connect 127.0.0.1 {server.Port}");
        using TestConnection connection = await server.AcceptAsync();

        foreach (string handle in (string[])[data, "(nil)", "0x7f0012345678"])
        {
            Assert.Equal("0", await program.CallAsync($"zero-out {handle} 0"));
            Assert.Equal("0", await program.CallAsync($"zero-out-all {handle}"));
            Assert.Equal("0 order 6", await program.CallAsync($"rotation {handle}"));
            Assert.Equal("0 0 0 0 0 0 0 0 0 0 0 0 0", await program.CallAsync($"bone-size {handle} 0"));
            Assert.Equal("0 xxx", await program.CallAsync($"header {handle} 0 3"));
        }

        Assert.Equal(0, connection.Socket.Available);
    }

    // Protocol.md section 6: which answers count.
    [Fact]
    public async Task Answers_of_all_kinds_are_taken_for_what_they_are()
    {
        byte[] floats = [.. Enumerable.Range(1, 12).SelectMany(static i => BitConverter.GetBytes((float)i))];
        (string Call, Func<ScriptedRequest, Task> Answer, string Result)[] cases =
        [
            ("zero-out {0} 0", static request => request.ReplyAsync([2]), "1"),
            ("zero-out {0} 0", static request => request.ReplyAsync(BitConverter.GetBytes(-1)), "1"),
            ("zero-out {0} 0", static request => request.ReplyAsync(BitConverter.GetBytes(256)), "0"),
            ("zero-out {0} 0", static request => request.ReplyAsync([]), "0"),
            ("zero-out-all {0}", static request => request.Connection.SendPiecesAsync(CommandScript.Packet([1, 0, 0, 0], request.Id), 1), "1"),
            ("rotation {0}", static request => request.ReplyAsync([3]), "1 order 3"),
            ("rotation {0}", static request => request.ReplyAsync(BitConverter.GetBytes(7)), "0 order 6"),
            ("rotation {0}", static request => request.SendAsync(CommandScript.Packet([], request.Id, size: -1)), "0 order 6"),
            ("bone-size {0} 0", request => request.ReplyAsync(floats[..47]), "0 0 0 0 0 0 0 0 0 0 0 0 0"),
            ("bone-size {0} 0", request => request.ReplyAsync([.. floats, 1, 2, 3]), "1 1 2 3 4 5 6 7 8 9 10 11 12"),
            ("header {0} 0 9", static request => request.ReplyAsync(Encoding.ASCII.GetBytes(Bvh + '\0')), "1 HIERARCHY"),
            ("header {0} 0 4", static request => request.ReplyAsync("no BVH"u8.ToArray()), "0 xxxx"),
            ("zero-out {0} 0", static request => request.SendAsync([0xFF, 0xAA, 1, 2, 3]).ContinueWith(_ => request.Connection.Close(), TaskScheduler.Default), "0"),
            ("zero-out {0} 0", static request => request.ReplyAsync([1, 0, 0, 0]), "1"),
        ];
        Func<ScriptedRequest, Task>? answer = null;
        using var server = new CommandScript(request => answer!(request));
        await using NativeProgram program = NativeProgram.Start("channel");
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}");

        foreach ((string call, Func<ScriptedRequest, Task> next, string result) in cases)
        {
            answer = next;
            string line = string.Format(CultureInfo.InvariantCulture, call, pipe);
            Assert.Equal((line, result), (line, await program.CallAsync(line)));
        }
    }

    // A root whose offset stands directly behind its brace, and other text that nobody would send. The program is told, and lives.
    [Theory]
    [InlineData("HIERARCHY\nROOT i\n{OFFSET")]
    [InlineData("HIERARCHY")]
    [InlineData("\x01\xFF{")]
    public async Task A_header_that_is_none_is_false_with_a_last_error(string hostile)
    {
        using CommandScript server = CommandScript.InTurn(
            request => request.ReplyAsync(Encoding.Latin1.GetBytes(hostile)), static request => request.ReplyAsync([1, 0, 0, 0]));
        await using NativeProgram program = NativeProgram.Start("channel");
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}");

        Assert.Equal("0 xxxx", await program.CallAsync($"header {pipe} 0 4"));

        Assert.NotEqual("No error.", await program.CallAsync("error"));
        Assert.Equal("1", await program.CallAsync($"zero-out {pipe} 0"));
        Assert.Equal(0, await program.EndAsync());
        Assert.Empty(program.Errors);
    }

    // The vendor's library takes another command's answer for its own, and gives its dead handle again.
    [Fact]
    public async Task After_a_time_out_the_handle_works_again()
    {
        using CommandScript server = CommandScript.InTurn(static request => request.ReplyAsync([1, 0, 0, 0], id: 1003), static request => request.ReplyAsync([1, 0, 0, 0]));
        await using NativeProgram program = NativeProgram.Start("channel");
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}");

        Assert.Equal("0", await program.CallAsync($"zero-out-all {pipe}"));

        Assert.Equal("No error.", await program.CallAsync("error"));
        Assert.Equal("0", await program.CallAsync($"get-status {pipe}"));
        Assert.Equal(pipe, await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}"));
        Assert.Equal("1", await program.CallAsync($"zero-out-all {pipe}"));
    }

    [Fact]
    public async Task Four_threads_ask_on_one_handle_and_each_gets_its_answers()
    {
        using CommandScript server = Answers();
        await using NativeProgram program = NativeProgram.Start("channel");
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}");

        Assert.Equal("25 25 25 25", await program.CallAsync($"threads {pipe}"));
        Assert.Equal(4 * 4 * 25, server.Requests);
    }

    [Fact]
    public async Task Closing_ends_a_command_that_waits()
    {
        var asked = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        using var server = new CommandScript(_ =>
        {
            asked.SetResult();
            return Task.CompletedTask;
        });
        await using NativeProgram program = NativeProgram.Start("channel");
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}");

        program.Write($"ask-aside {pipe}");
        await asked.Task.Soon();
        program.Write($"close {pipe}");

        string[] lines = [await program.ReadAsync(), await program.ReadAsync()];
        Assert.Equal(["= closed", "asked 0"], lines.Order(StringComparer.Ordinal));
        Assert.Equal(0, await program.EndAsync());
        Assert.Equal(1, server.Requests);
    }

    [Fact]
    public async Task A_server_that_has_gone_or_never_was_is_told()
    {
        await using NativeProgram program = NativeProgram.Start("channel");
        CommandScript server = Answers();
        int port = server.Port;
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {port}");
        server.Dispose();

        Assert.Equal("0", await program.CallAsync($"zero-out-all {pipe}"));
        Assert.Equal("2", await program.CallAsync($"get-status {pipe}"));
        Assert.Equal("(nil)", await program.CallAsync($"connect-commands 127.0.0.1 {port}"));
        Assert.Equal($"Failed to connect to '127.0.0.1:{port}'. System error code: 111", await program.CallAsync("error"));
    }

    [Fact]
    public async Task Frame_callbacks_may_ask_and_a_command_connection_tells_no_status()
    {
        using CommandScript answers = Answers();
        using var server = new TestServer();
        await using var driver = new Driver();
        string pipe = await driver.CallAsync($"connect-command 127.0.0.1 {answers.Port}");
        Assert.Empty(driver.Statuses);
        (_, TestConnection connection) = await driver.ConnectAsync(server);
        await driver.CallAsync("when frame rotation " + pipe);

        await connection.SendAsync(TestPackets.Motion(1));
        await driver.UntilAsync(() => driver.Reactions.Count == 1);

        Assert.Equal("1 4", driver.Reactions[0]);
        await driver.CallAsync("close " + pipe);
        connection.Dispose();
        await driver.EndAsync();
        Assert.DoesNotContain(driver.Statuses, status => status.Sender == pipe);
    }

    private static CommandScript Answers() => new(static request => request.Id switch
    {
        1001 => request.ReplyAsync([request.Avatar == 0 ? (byte)1 : (byte)0, 0, 0, 0]),
        1002 => request.ReplyAsync([1, 0, 0, 0]),
        1003 => request.ReplyAsync([4, 0, 0, 0]),
        1004 => request.ReplyAsync([.. Enumerable.Range(1, 12).SelectMany(static i => BitConverter.GetBytes(i / 10f))]),
        _ => request.ReplyAsync(Encoding.ASCII.GetBytes(Bvh)),
    });
}
