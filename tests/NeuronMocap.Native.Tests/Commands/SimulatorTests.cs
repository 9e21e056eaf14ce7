using System.Diagnostics;
using System.Net;
using NeuronMocap.Native.Tests.Infrastructure;

namespace NeuronMocap.Native.Tests.Commands;

/// <summary>Programs of both generations with the installed simulator.</summary>
public sealed class SimulatorTests
{
    [Fact]
    public async Task The_simulator_program_serves_both_generations()
    {
        await using NativeProgram newer = NativeProgram.Start("channel");
        await using NativeProgram older = NativeProgram.Start("b12");
        await using NativeProgram simulator = Start("--port", "0", "--commands", "0", "--avatars", "2", "--header", "old", "--order", "XZY");
        int port = await PortAsync(simulator, "Listening on ");
        int commands = await PortAsync(simulator, "Commands on ");

        string pipe = await newer.CallAsync($"connect-commands 127.0.0.1 {commands}");
        Assert.Equal("1", await newer.CallAsync($"zero-out {pipe} 1"));
        Assert.Equal("0", await newer.CallAsync($"zero-out {pipe} 2"));
        Assert.Equal("1", await newer.CallAsync($"zero-out-all {pipe}"));
        Assert.Equal("1 order 0", await newer.CallAsync($"rotation {pipe}"));
        Assert.StartsWith("1 0.", await newer.CallAsync($"bone-size {pipe} 1"), StringComparison.Ordinal);
        Assert.StartsWith("0 0 ", await newer.CallAsync($"bone-size {pipe} 2"), StringComparison.Ordinal);
        Assert.Matches(@"^1 HIERARCHY\\r\\nROOT Hips.*MOTION.*\\0$", await newer.CallAsync($"header {pipe} 0 100000"));

        await older.CallAsync("register");
        string socket = await older.CallAsync($"connect 127.0.0.1 {port}");
        Assert.StartsWith($"frame frames {socket} version 1.0.0.2 count 354 ", await older.ReadAsync("frame"), StringComparison.Ordinal);
        Assert.Equal("1", await older.CallAsync($"fetch {socket} 5"));
        Assert.EndsWith(" id 5 version 01000002 length 64 count 0 parameters 2 0 no data", await older.ReadAsync("answer"), StringComparison.Ordinal);
        Assert.Equal("1", await older.CallAsync($"fetch-avatar {socket} 1 4"));
        Assert.EndsWith(" bytes 'HIERARCHY'", await older.ReadAsync("answer"), StringComparison.Ordinal);
    }

    // Built with the configuration of the tests.
    private static NativeProgram Start(params string[] arguments)
    {
        var output = new DirectoryInfo(AppContext.BaseDirectory);
        string program = Repository.PathOf("src", "NeuronMocap.Tool", "bin", output.Parent!.Name, output.Name, "neuron-mocap.dll");
        return NativeProgram.Start(new ProcessStartInfo(Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet", [program, "simulate", .. arguments]));
    }

    private static async Task<int> PortAsync(NativeProgram simulator, string start) => IPEndPoint.Parse((await simulator.ReadAsync(start))[start.Length..]).Port;
}
