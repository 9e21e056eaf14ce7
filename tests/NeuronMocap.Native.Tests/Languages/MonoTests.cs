using System.Diagnostics;
using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Server;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Native.Tests.Languages;

/// <summary>A C# script with a wrapper of DllImport lines, on Mono, as in a Unity project that keeps its wrapper.</summary>
public sealed class MonoTests : IDisposable
{
    private const int Frames = 300;

    private readonly string _folder = Directory.CreateTempSubdirectory("neuron-mocap-mono-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public async Task A_script_receives_every_frame_and_sends_commands()
    {
        SystemTool.Require("mcs", "mono-devel");
        string library = NativeFiles.Library;
        string program = Path.Combine(_folder, "program.exe");
        string[] sources =
        [
            .. Directory.GetFiles(Path.Combine(NativeFiles.Sources, "mono"), "*.cs"),
            .. ((string[])["W2Script.cs", "ReceivedFrame.cs"]).Select(static file => Repository.PathOf("tests", "NeuronMocap.Compatibility.Scripts", file)),
        ];
        Assert.Equal((0, "", ""), await SystemTool.RunAsync("mcs", ["-warnaserror", "-out:" + program, .. sources]));
        var options = new BroadcasterOptions
        {
            Sources = [new TestSource(0)],
            AvatarNames = ["陈"],
            Calculation = TestSource.WriteCalculation,
            Port = 0,
            FrameRate = 500,
            QueueCapacity = 10_000,
            WaitForClient = true,
        };
        using var server = new Broadcaster(options);
        server.Start();
        using var asked = new Broadcaster(new BroadcasterOptions { Sources = [new TestSource()], Port = 0, RotationOrder = RotationOrder.XYZ });
        using var commands = new CommandServer(asked, new CommandServerOptions { Port = 0 });
        commands.Start();
        int port = server.LocalEndPoint!.Port;
        var start = new ProcessStartInfo("mono", [program, $"{port}", $"{commands.LocalEndPoint!.Port}", $"{Frames}"]);
        start.Environment["LD_LIBRARY_PATH"] = Path.GetDirectoryName(library);

        await using NativeProgram script = NativeProgram.Start(start);

        Assert.Equal("motion 1.1.0.0 354 calculation 1.0.0.3 946 caught 1", await script.ReadAsync());
        Assert.Equal("True True False", await script.ReadAsync());
        Assert.Equal("False", await script.ReadAsync());
        Assert.Equal(
            [
                "CS_Starting Connecting to 127.0.0.1:1 ...",
                "CS_Starting Failed to connect to '127.0.0.1:1'.",
                "CS_OffWork Service is stoped",
                "Failed to connect to '127.0.0.1:1'. System error code: 111",
                $"CS_Starting Connecting to 127.0.0.1:{port} ...",
                $"CS_Running Successfully connected to '127.0.0.1:{port}'.",
                "CS_OffWork Service is stoped",
            ],
            [
                await script.ReadAsync(), await script.ReadAsync(), await script.ReadAsync(), await script.ReadAsync(),
                await script.ReadAsync(), await script.ReadAsync(), await script.ReadAsync(),
            ]);
        Assert.Equal(0, await script.EndAsync());
    }
}
