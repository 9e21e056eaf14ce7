using System.Diagnostics;

namespace NeuronMocap.Tool.Tests.Infrastructure;

/// <summary>The program in a terminal of tmux, with its own tmux server.</summary>
internal sealed class TmuxTerminal : IAsyncDisposable
{
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(60);

    private readonly string _name = $"neuron-mocap-{Guid.NewGuid():N}";

    /// <summary>Whether tmux exists.</summary>
    public static bool Exists => !OperatingSystem.IsWindows() && InstalledPrograms.Have("tmux");

    /// <summary>Runs the program. The terminal stays after it ends, with the exit code in the last line.</summary>
    public static async Task<TmuxTerminal> StartAsync(int columns, int rows, string args)
    {
        var terminal = new TmuxTerminal();
        string host = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet";
        string command = $"'{host}' '{ToolProcess.PathOf("neuron-mocap")}' {args}; echo \"ended with $?\"; cat";
        await terminal.RunAsync("-f", "/dev/null", "new-session", "-d", "-x", $"{columns}", "-y", $"{rows}", command);
        return terminal;
    }

    public Task TypeAsync(string key) => RunAsync("send-keys", key);

    /// <summary>Waits until the screen meets a condition.</summary>
    /// <returns>The lines of the screen.</returns>
    public async Task<string[]> WaitForAsync(Func<string[], bool> isThere)
    {
        var clock = Stopwatch.StartNew();
        while (true)
        {
            string[] lines = [.. (await RunAsync("capture-pane", "-p")).Split('\n').Select(static line => line.TrimEnd())];
            if (isThere(lines))
                return lines;

            Assert.True(clock.Elapsed < Limit, string.Join('\n', lines));
            await Task.Delay(20, TestContext.Current.CancellationToken);
        }
    }

    public async ValueTask DisposeAsync() => await RunAsync("kill-server");

    private async Task<string> RunAsync(params string[] args)
    {
        var start = new ProcessStartInfo("tmux", ["-L", _name, .. args]) { RedirectStandardOutput = true, RedirectStandardError = true, UseShellExecute = false };
        using Process tmux = Process.Start(start)!;
        string output = await tmux.StandardOutput.ReadToEndAsync(TestContext.Current.CancellationToken);
        await tmux.WaitForExitAsync(TestContext.Current.CancellationToken);
        return output;
    }
}
