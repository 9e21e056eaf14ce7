using System.Diagnostics;
using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Server;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Native.Tests.Languages;

/// <summary>A Python program on ctypes.</summary>
public sealed class PythonTests
{
    private const int FramesOfAThread = 50;

    // One process for all checks, because each has to start an interpreter. Its connection is never closed.
    [Fact]
    public async Task Frames_status_and_commands_reach_a_Python_program()
    {
        using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new TestSource()], Port = 0, RotationOrder = RotationOrder.ZXY });
        using var commands = new CommandServer(broadcaster, new CommandServerOptions { Port = 0 });
        commands.Start();
        using var server = new TestServer();
        await using NativeProgram program = Start("receive", $"{server.Port}", $"{commands.LocalEndPoint!.Port}");
        Assert.Equal("sizes 64 64 64 48", await program.ReadAsync());
        Assert.Equal("status 3 1 Connecting to 127.0.0.1:1 ...", await program.ReadAsync());
        Assert.Equal("refused None Failed to connect to '127.0.0.1:1'. System error code: 111", await program.ReadAsync("refused"));
        Assert.Equal("connected True 0 1", await program.ReadAsync("connected"));
        using TestConnection connection = await server.AcceptAsync();

        // The exception in the callback of frame 13 ends nothing.
        await connection.SendPiecesAsync(
            TestPackets.Join(
                TestPackets.Motion(13, avatar: 2, count: 186, name: "陈"),
                DataReplies.AvatarCount(3),
                TestPackets.Calculation(14),
                TestPackets.Motion(1, layout: HeaderLayout.Old)),
            1000);
        Assert.Equal("frame 1 True 1.1.0.0 2 陈 13 0 1 186 13.25 13.4306640625", await program.ReadAsync());
        Assert.Equal("answer 4 5 3 None", await program.ReadAsync());
        Assert.Equal("calculation 2 True 14 946 14.9228515625", await program.ReadAsync());
        Assert.Equal("frame 1 True 1.1.0.0 0 Char00 0 1 0 354 1.0 1.3447265625", await program.ReadAsync());
        await Limits.UntilAsync(() => program.Errors.Contains("ZeroDivisionError: of the callback", StringComparison.Ordinal));

        program.Write("go on");
        Assert.Equal("commands True False True 4 True True True HIERARCHY False", await program.ReadAsync());
        Assert.Equal("threads started", await program.ReadAsync());
        for (int i = 0; i < 3; i++)
        {
            using TestConnection thread = await server.AcceptAsync();
            await thread.SendAsync(TestPackets.Motions(1, FramesOfAThread));
            await Limits.UntilAsync(() => thread.Socket.Poll(0, System.Net.Sockets.SelectMode.SelectRead));
        }

        Assert.Equal("threads [(50, 0), (50, 0), (50, 0)]", await program.ReadAsync());
        Assert.Equal("ends without closing 0", await program.ReadAsync());
        Assert.Equal(0, await program.EndAsync());
    }

    [Fact]
    public async Task An_interrupt_while_receiving_raises_KeyboardInterrupt()
    {
        using var server = new Broadcaster(new BroadcasterOptions { Sources = [new TestSource()], Port = 0, FrameRate = 200 });
        server.Start();
        await using NativeProgram program = Start("wait", $"{server.LocalEndPoint!.Port}");
        await program.ReadAsync("frame");

        Signals.Send("INT", program.Id);

        await program.ReadAsync("interrupted");
        Assert.Equal(128 + 2, await program.EndAsync());
        Assert.Contains("KeyboardInterrupt", program.Errors, StringComparison.Ordinal);
    }

    private static NativeProgram Start(params string[] arguments)
    {
        SystemTool.Require("python3", "python3");
        var start = new ProcessStartInfo("python3", [Path.Combine(NativeFiles.Sources, "python", "reader.py"), NativeFiles.Library, .. arguments]);
        start.Environment["PYTHONIOENCODING"] = "utf-8";
        return NativeProgram.Start(start);
    }
}
