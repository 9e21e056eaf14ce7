using System.Diagnostics;
using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Server;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Native.Tests.Languages;

/// <summary>A Java program on JNA.</summary>
public sealed class JavaTests : IDisposable
{
    // The location on Debian.
    private const string Jna = "/usr/share/java/jna.jar";

    private readonly string _folder = Directory.CreateTempSubdirectory("neuron-mocap-java-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    // One process for all checks, because a virtual machine starts slowly.
    [Fact]
    public async Task Frames_status_and_commands_reach_a_Java_program()
    {
        SystemTool.Require("javac", "default-jdk-headless");
        Assert.SkipUnless(File.Exists(Jna), "JNA is not installed (Debian's libjna-java).");
        string library = NativeFiles.Library;
        Assert.Equal((0, "", ""), await SystemTool.RunAsync("javac", "-cp", Jna, "-d", _folder, Path.Combine(NativeFiles.Sources, "java", "Reader.java")));
        var options = new BroadcasterOptions
        {
            Sources = [new TestSource()],
            AvatarNames = ["陈"],
            Calculation = TestSource.WriteCalculation,
            Port = 0,
            FrameRate = 200,
            QueueCapacity = 10_000,
            WaitForClient = true,
        };
        using var server = new Broadcaster(options);
        server.Start();
        using var asked = new Broadcaster(new BroadcasterOptions { Sources = [new TestSource()], Port = 0, RotationOrder = RotationOrder.XYZ });
        using var commands = new CommandServer(asked, new CommandServerOptions { Port = 0 });
        commands.Start();
        var start = new ProcessStartInfo(
            "java",
            [
                "-Djna.library.path=" + Path.GetDirectoryName(library), "-cp", Jna + ":" + _folder, "Reader",
                $"{server.LocalEndPoint!.Port}", $"{commands.LocalEndPoint!.Port}",
            ]);
        start.Environment["LC_ALL"] = "C.UTF-8";

        await using NativeProgram program = NativeProgram.Start(start);

        Assert.Equal("sizes 64 64 48 offsets 6 14 46 62", await program.ReadAsync());
        Assert.Equal("refused null Failed to connect to '127.0.0.1:1'. System error code: 111", await program.ReadAsync("refused"));
        Assert.Equal("frame 1 true 0 陈", await program.ReadAsync("frame"));
        Assert.Equal("calculation 2 true 946", await program.ReadAsync("calculation"));
        Assert.Equal("commands true false 1 true 2 true true true HIERARCHY", await program.ReadAsync("commands"));
        Assert.Equal("signals 50005 true", await program.ReadAsync("signals"));
        Assert.Equal("closed true 2 true", await program.ReadAsync("closed"));
        Assert.Equal(0, await program.EndAsync());
        Assert.Empty(program.Errors);
    }
}
