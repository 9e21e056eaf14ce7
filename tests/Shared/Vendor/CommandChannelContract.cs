using System.Globalization;
using System.Net.Sockets;
using System.Text;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Vendor;

// Commands on their own connection, as in b17 and b18. channel.c in tests/native describes the lines.
public abstract class CommandChannelContract
{
    private const string Bvh = "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\n"
        + " End Site\n {\n  OFFSET 0 1 0\n }\n}\n";

    private static readonly string Printed = Bvh.Replace("\n", "\\n", StringComparison.Ordinal);

    private protected abstract VendorDriver Start();

    /// <summary>Starts a program that also registers callbacks.</summary>
    private protected abstract VendorDriver StartWithCallbacks();

    [Fact]
    public async Task Every_command_is_answered()
    {
        await using VendorDriver driver = Start();
        await AskForEverythingAsync(driver);
    }

    // A zero byte follows the text if there is room. Nothing is written beyond the room.
    [Fact]
    public async Task The_header_fills_the_given_memory()
    {
        using CommandScript server = Answers();
        await using VendorDriver driver = Start();
        string pipe = await ConnectAsync(driver, server);

        Assert.Equal($"1 {Printed}\\0", await driver.CallAsync($"header {pipe} 0 100000"));
        Assert.Equal($"1 {Printed}\\0", await driver.CallAsync($"header {pipe} 0 {Bvh.Length + 1}"));
        Assert.Equal($"1 {Printed}", await driver.CallAsync($"header {pipe} 0 {Bvh.Length}"));
        Assert.Equal("1 HIERARCHY", await driver.CallAsync($"header {pipe} 0 9"));
        Assert.Equal("1 H", await driver.CallAsync($"header {pipe} 0 1"));
        int asked = server.Requests;
        Assert.Equal("0 ", await driver.CallAsync($"header {pipe} 0 0"));
        Assert.Equal("0 ", await driver.CallAsync($"header {pipe} 0 -5"));
        Assert.Equal(asked, server.Requests);

        // Without an answer, the memory is not changed.
        Assert.Equal("0 xxxx", await driver.CallAsync($"header {pipe} -1 4"));
    }

    [Fact]
    public async Task Other_handles_take_no_commands()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        (string data, TestConnection connection) = await driver.ConnectAsync(server);

        foreach (string handle in (string[])[data, VendorDriver.None, "0x7f0012345678"])
        {
            Assert.Equal("0", await driver.CallAsync($"zero-out {handle} 0"));
            Assert.Equal("0", await driver.CallAsync($"zero-out-all {handle}"));
            Assert.Equal("0 order 6", await driver.CallAsync($"rotation {handle}"));
            Assert.Equal("0 0 0 0 0 0 0 0 0 0 0 0 0", await driver.CallAsync($"bone-size {handle} 0"));
            Assert.Equal("0 xxx", await driver.CallAsync($"header {handle} 0 3"));
        }

        Assert.Equal(0, connection.Socket.Available);
        connection.Dispose();
    }

    // protocol.md section 6: which answers count.
    [Fact]
    public async Task Only_valid_answers_count()
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
        await using VendorDriver driver = Start();
        string pipe = await ConnectAsync(driver, server);

        foreach ((string call, Func<ScriptedRequest, Task> next, string result) in cases)
        {
            answer = next;
            string line = string.Format(CultureInfo.InvariantCulture, call, pipe);
            Assert.Equal((line, result), (line, await driver.CallAsync(line)));
        }
    }

    // A root whose offset directly follows its brace, and other unusual text. The program is informed and continues.
    [Theory]
    [InlineData("HIERARCHY\nROOT i\n{OFFSET")]
    [InlineData("HIERARCHY")]
    [InlineData("\x01\xFF{")]
    [InlineData("no BVH")]
    public async Task An_invalid_header_sets_the_last_error(string hostile)
    {
        using CommandScript server = CommandScript.InTurn(
            request => request.ReplyAsync(Encoding.Latin1.GetBytes(hostile)), static request => request.ReplyAsync([1, 0, 0, 0]));
        await using VendorDriver driver = Start();
        Assert.Equal(VendorDriver.None, await driver.CallAsync("connect-commands 127.0.0.1 0"));
        string error = await driver.CallAsync("error");
        string pipe = await ConnectAsync(driver, server);

        Assert.Equal("0 xxxx", await driver.CallAsync($"header {pipe} 0 4"));

        Assert.NotEqual(error, await driver.CallAsync("error"));
        Assert.Equal("1", await driver.CallAsync($"zero-out {pipe} 0"));
        await driver.EndAsync();
    }

    // The vendor's library takes another command's answer for its own, closes the connection after a time-out, and returns its dead handle again.
    [Fact]
    public async Task The_handle_works_after_a_time_out()
    {
        using CommandScript server = CommandScript.InTurn(static request => request.ReplyAsync([1, 0, 0, 0], id: 1003), static request => request.ReplyAsync([1, 0, 0, 0]));
        await using VendorDriver driver = Start();
        string pipe = await ConnectAsync(driver, server);
        string error = await driver.CallAsync("error");

        Assert.Equal("0", await driver.CallAsync($"zero-out-all {pipe}"));

        Assert.Equal(error, await driver.CallAsync("error"));
        Assert.Equal("0", await driver.CallAsync($"get-status {pipe}"));
        Assert.Equal(pipe, await ConnectAsync(driver, server));
        Assert.Equal("1", await driver.CallAsync($"zero-out-all {pipe}"));
    }

    [Fact]
    public async Task A_refused_connection_is_null_with_an_error()
    {
        await using VendorDriver driver = Start();
        CommandScript server = Answers();
        int port = server.Port;
        string pipe = await ConnectAsync(driver, server);
        server.Dispose();

        Assert.Equal("0", await driver.CallAsync($"zero-out-all {pipe}"));
        Assert.Equal("2", await driver.CallAsync($"get-status {pipe}"));
        Assert.Equal(VendorDriver.None, await driver.CallAsync($"connect-commands 127.0.0.1 {port}"));
        Assert.Equal($"Failed to connect to '127.0.0.1:{port}'. System error code: {VendorError.CodeOf(SocketError.ConnectionRefused)}", await driver.CallAsync("error"));
        Assert.Equal(VendorDriver.None, await driver.CallAsync($"connect-commands no-such-computer.invalid {port}"));
        Assert.EndsWith(" 11001", await driver.CallAsync("error"), StringComparison.Ordinal);
    }

    // The vendor's library still reports that it runs.
    [Fact]
    public async Task The_status_shows_that_the_server_closed_an_idle_connection()
    {
        var accepted = new TaskCompletionSource<TestConnection>(TaskCreationOptions.RunContinuationsAsynchronously);
        using var server = new CommandScript(
            static request => request.ReplyAsync([1, 0, 0, 0]),
            connection =>
            {
                accepted.TrySetResult(connection);
                return Task.CompletedTask;
            });
        await using VendorDriver driver = Start();
        string pipe = await ConnectAsync(driver, server);
        Assert.Equal("0", await driver.CallAsync($"get-status {pipe}"));

        (await accepted.Task.Soon()).Close();
        while (await driver.CallAsync($"get-status {pipe}") != "2")
            await Task.Delay(1, TestContext.Current.CancellationToken);

        string again = await ConnectAsync(driver, server);
        Assert.NotEqual(pipe, again);
        Assert.Equal("1", await driver.CallAsync($"zero-out-all {again}"));
        Assert.Equal("0", await driver.CallAsync($"get-status {again}"));
        Assert.Equal("0", await driver.CallAsync($"zero-out-all {pipe}"));
    }

    [Fact]
    public async Task Frame_callbacks_may_ask_and_command_connections_call_no_status_callback()
    {
        using CommandScript answers = Answers();
        using var server = new TestServer();
        await using VendorDriver driver = StartWithCallbacks();
        string pipe = await ConnectAsync(driver, answers);
        Assert.Empty(driver.Statuses);
        (_, TestConnection connection) = await driver.ConnectAsync(server);
        await driver.CallAsync("when frame rotation " + pipe);

        await connection.SendAsync(TestPackets.Motion(1));
        await driver.UntilAsync(() => driver.Reactions.Count == 1);

        Assert.Equal("1 order 4", driver.Reactions[0]);
        await driver.CallAsync("close " + pipe);
        connection.Dispose();
        await driver.EndAsync();
        Assert.DoesNotContain(driver.Statuses, status => status.Sender == pipe);
    }

    private protected static async Task AskForEverythingAsync(VendorDriver driver)
    {
        using CommandScript server = Answers();
        string pipe = await ConnectAsync(driver, server);
        Assert.Equal("0", await driver.CallAsync($"get-status {pipe}"));

        Assert.Equal("1", await driver.CallAsync($"zero-out {pipe} 0"));
        Assert.Equal("0", await driver.CallAsync($"zero-out {pipe} 7"));
        Assert.Equal("0", await driver.CallAsync($"zero-out {pipe} -1"));
        Assert.Equal("1", await driver.CallAsync($"zero-out-all {pipe}"));
        Assert.Equal("1 order 4", await driver.CallAsync($"rotation {pipe}"));
        Assert.Equal(
            "1 0.100000001 0.200000003 0.300000012 0.400000006 0.5 0.600000024 0.699999988 0.800000012 0.899999976 1 1.10000002 1.20000005",
            await driver.CallAsync($"bone-size {pipe} 1"));

        Assert.Equal("closed", await driver.CallAsync($"close {pipe}"));
        Assert.Equal("0", await driver.CallAsync($"zero-out {pipe} 0"));
        Assert.Equal("2", await driver.CallAsync($"get-status {pipe}"));
        await driver.EndAsync();
    }

    /// <summary>Answers every command. Zero out succeeds for avatar 0.</summary>
    private protected static CommandScript Answers() => new(static request => request.Id switch
    {
        1001 => request.ReplyAsync([request.Avatar == 0 ? (byte)1 : (byte)0, 0, 0, 0]),
        1002 => request.ReplyAsync([1, 0, 0, 0]),
        1003 => request.ReplyAsync([4, 0, 0, 0]),
        1004 => request.ReplyAsync([.. Enumerable.Range(1, 12).SelectMany(static i => BitConverter.GetBytes(i / 10f))]),
        _ => request.ReplyAsync(Encoding.ASCII.GetBytes(Bvh)),
    });

    private static async Task<string> ConnectAsync(VendorDriver driver, CommandScript server)
    {
        string pipe = await driver.CallAsync($"connect-commands 127.0.0.1 {server.Port}");
        Assert.NotEqual(VendorDriver.None, pipe);
        return pipe;
    }
}
