using System.Globalization;
using NeuronMocap.Commands;
using NeuronMocap.Native.Tests.Generations;
using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Server;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Native.Tests.Commands;

/// <summary>Commands on the data connection, as b12 programs send them.</summary>
public sealed class DataCommandTests
{
    [Fact]
    public async Task The_simulator_answers_every_command_while_it_sends_frames()
    {
        var options = new BroadcasterOptions
        {
            Sources = [new TestSource(0), new TestSource(1)],
            Port = 0,
            FrameRate = 100,
            DataVersion = DataVersion.Old,
            Fragment = 100,
        };
        using var server = new Broadcaster(options);
        server.Start();
        await using NativeProgram program = NativeProgram.Start("b12");
        await program.CallAsync("register");
        string socket = await program.CallAsync($"connect 127.0.0.1 {server.LocalEndPoint!.Port}");

        Assert.Equal("1", await program.CallAsync($"fetch {socket} 5"));
        Assert.Equal($"answer answers {socket} id 5 version 01000002 length 64 count 0 parameters 2 0 no data", await program.ReadAsync("answer"));
        Assert.Equal("1", await program.CallAsync($"fetch-avatar {socket} 1 3"));
        Assert.Equal($"answer answers {socket} id 3 version 01000002 length 64 count 0 parameters 1 100 no data", await program.ReadAsync("answer"));
        Assert.Equal("1", await program.CallAsync($"fetch-avatar {socket} 1 0"));
        string sizes = await program.ReadAsync("answer");
        Assert.StartsWith($"answer answers {socket} id 0 version 01000002 length {64 + (59 * 64)} count 59 parameters 0 0 Hips=", sizes, StringComparison.Ordinal);
        Assert.Equal(59, sizes.Count(static letter => letter == '='));
        Assert.Equal("1", await program.CallAsync($"fetch {socket} 4"));
        string text = await program.ReadAsync("answer");
        Assert.StartsWith($"answer answers {socket} id 4 version 01000002 ", text, StringComparison.Ordinal);
        Assert.EndsWith(" bytes 'HIERARCHY'", text, StringComparison.Ordinal);

        // Watched values are also reported at once.
        Assert.Equal("1", await program.CallAsync($"watch {socket} 6"));
        Assert.Equal([ModeOf(socket, 0, 2), ModeOf(socket, 1, 2)], [await program.ReadAsync("answer"), await program.ReadAsync("answer")]);
        server.SetCombinationMode(1, CombinationMode.ArmOnly);
        Assert.Equal(ModeOf(socket, 1, 0), await program.ReadAsync("answer"));
        Assert.Equal("1", await program.CallAsync($"unwatch {socket} 6"));
        Assert.Equal("1", await program.CallAsync($"fetch {socket} 5"));
        await program.ReadAsync("answer");
        server.SetCombinationMode(0, CombinationMode.UpperBody);
        Assert.Equal("1", await program.CallAsync($"fetch {socket} 5"));
        Assert.Contains(" id 5 ", await program.ReadAsync("answer"), StringComparison.Ordinal);
        await program.ReadAsync("frame");
        Assert.Equal(0, await program.EndAsync());
        Assert.Empty(program.Errors);
    }

    // Requests byte for byte (protocol.md section 7).
    [Fact]
    public async Task Requests_have_the_bytes_of_the_old_protocol()
    {
        using var server = new TestServer();
        await using NativeProgram program = NativeProgram.Start("b12");
        string socket = await program.CallAsync($"connect 127.0.0.1 {server.Port}");
        using TestConnection connection = await server.AcceptAsync();

        foreach ((string call, int id, int parameter) in ((string, int, int)[])[("fetch {0} 5", 5, 0), ("fetch-avatar {0} 3 0", 0, 3), ("watch {0} 6", 7, 6), ("unwatch {0} 6", 8, 6)])
        {
            Assert.Equal("1", await program.CallAsync(string.Format(CultureInfo.InvariantCulture, call, socket)));
            byte[] request = new byte[64];
            for (int count = 0; count < request.Length;)
                count += await connection.Socket.ReceiveAsync(request.AsMemory(count), TestContext.Current.CancellationToken).Soon();

            Assert.Equal(DataReplies.Make(id, dataCount: 0, parameter, 0, []), request);
        }
    }

    // The vendor's library lost split packets.
    [Theory]
    [InlineData(1)]
    [InlineData(63)]
    [InlineData(65)]
    [InlineData(5000)]
    public async Task Answers_in_any_pieces_arrive_between_frames(int size)
    {
        using var server = new TestServer();
        await using NativeProgram program = NativeProgram.Start("b12");
        await program.CallAsync("register");
        string socket = await program.CallAsync($"connect 127.0.0.1 {server.Port}");
        using TestConnection connection = await server.AcceptAsync();

        // Unrequested replies, with lengths that servers are known to get wrong.
        await connection.SendPiecesAsync(
            TestPackets.Join(
                DataReplies.AvatarCount(3),
                DataReplies.BoneSizes(("Hips", 1.5f), ("陈", -0f), (new string('n', 60), 2.25f)),
                TestPackets.Motion(1, count: 180),
                DataReplies.BvhText("HIERARCHY\nROOT Hips\n"),
                DataReplies.Frequency(1, 60),
                DataReplies.CombinationMode(2, 1),
                DataReplies.Make(1, dataCount: 0, 7, 8, [], dataLength: 4),
                TestPackets.Motion(2, count: 180)),
            size);

        Assert.Equal(
            [
                $"answer answers {socket} id 5 version 01000002 length 64 count 0 parameters 3 0 no data",
                $"answer answers {socket} id 0 version 01000002 length 256 count 3 parameters 0 0 Hips=1.5 陈=-0 {new string('n', 60)}=2.25",
                B12Frame.LineOf(socket, 1, count: 180),
                $"answer answers {socket} id 4 version 01000002 length 84 count 20 parameters 0 0 20 bytes 'HIERARCHY'",
                $"answer answers {socket} id 3 version 01000002 length 64 count 0 parameters 1 60 no data",
                ModeOf(socket, 2, 1),
                $"answer answers {socket} id 1 version 01000002 length 4 count 0 parameters 7 8 no data",
                B12Frame.LineOf(socket, 2, count: 180),
            ],
            [
                await program.ReadAsync("answer"), await program.ReadAsync(), await program.ReadAsync(), await program.ReadAsync(),
                await program.ReadAsync(), await program.ReadAsync(), await program.ReadAsync(), await program.ReadAsync(),
            ]);
    }

    [Fact]
    public async Task Callbacks_may_send_commands()
    {
        using var server = new Broadcaster(new BroadcasterOptions { Sources = [new TestSource()], Port = 0, FrameRate = 100 });
        server.Start();
        await using NativeProgram program = NativeProgram.Start("b12");
        await program.CallAsync("register");
        await program.CallAsync("in-answer 6");
        string socket = await program.CallAsync($"connect 127.0.0.1 {server.LocalEndPoint!.Port}");
        await program.CallAsync("in-frame 5");

        Assert.Equal("sent in frame 1", await program.ReadAsync("sent"));
        Assert.Contains(" id 5 ", await program.ReadAsync("answer"), StringComparison.Ordinal);
        Assert.Equal("sent in answer 1", await program.ReadAsync("sent"));
        Assert.Equal(ModeOf(socket, 0, 2), await program.ReadAsync("answer"));
    }

    [Fact]
    public async Task Commands_need_an_open_TCP_connection_and_answers_need_a_callback()
    {
        using var server = new TestServer();
        using CommandScript commands = CommandScript.Always([1, 0, 0, 0]);
        await using NativeProgram program = NativeProgram.Start("b12");
        string socket = await program.CallAsync($"connect 127.0.0.1 {server.Port}");
        string service = await program.CallAsync($"udp {FreePort.Next()}");
        string channel = await program.CallAsync($"connect-commands 127.0.0.1 {commands.Port}");
        using TestConnection connection = await server.AcceptAsync();
        Assert.DoesNotContain("(nil)", (string[])[socket, service, channel]);

        foreach (string handle in (string[])[service, channel, "(nil)", "0x7f0012345678"])
            await AssertAllAsync("0", handle);

        await program.CallAsync("register");
        await connection.SendAsync(TestPackets.Motion(2));
        await program.ReadAsync("frame");
        await program.CallAsync("unregister");
        await connection.SendAsync(TestPackets.Join(DataReplies.AvatarCount(1), TestPackets.Motion(3)));
        Assert.Equal(B12Frame.LineOf(socket, 3), await program.ReadAsync());
        await AssertAllAsync("1", socket);

        connection.Close();
        await program.ReadAsync("status statuses 0 Data thread exited.");
        await AssertAllAsync("0", socket);
        await program.CallAsync($"close {socket}");
        await AssertAllAsync("0", socket);
        Assert.Equal(0, commands.Requests);

        async Task AssertAllAsync(string result, string handle)
        {
            foreach (string call in (string[])[$"fetch {handle} 5", $"fetch-avatar {handle} 0 0", $"watch {handle} 6", $"unwatch {handle} 6"])
                Assert.Equal(result, await program.CallAsync(call));
        }
    }

    private static string ModeOf(string socket, int avatar, int mode) =>
        $"answer answers {socket} id 6 version 01000002 length 64 count 0 parameters {avatar} {mode} no data";
}
