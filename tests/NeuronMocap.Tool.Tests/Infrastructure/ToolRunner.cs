using System.Text;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Tests.Infrastructure;

/// <summary>What a run of the monitor left behind.</summary>
internal sealed record ToolResult(int ExitCode, string[] Output, string[] Error)
{
    public string[] OfType(string type) => [.. Output.Where(line => line.StartsWith($"{{\"type\":\"{type}\"", StringComparison.Ordinal))];
}

/// <summary>Runs the monitor inside the test's process, with its output in memory.</summary>
internal static class ToolRunner
{
    // Far beyond what any run takes; a test that needs it has failed.
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(60);

    public static async Task<ToolResult> RunAsync(params string[] args)
    {
        using var output = new MemoryStream();
        return await RunAsync(output, args) with { Output = Lines(Encoding.UTF8.GetString(output.ToArray())) };
    }

    public static async Task<ToolResult> RunAsync(Stream output, string[] args)
    {
        using var error = new StringWriter();
        using var streams = new StandardStreams(output, error, IsTerminal: false);
        int exitCode = await CommandLine.RunAsync(args, streams, TestContext.Current.CancellationToken)
            .WaitAsync(Limit, TestContext.Current.CancellationToken);
        return new ToolResult(exitCode, [], Lines(error.ToString()));
    }

    /// <summary>As on a terminal that says it is so wide.</summary>
    public static async Task<ToolResult> RunOnTerminalAsync(int columns, params string[] args)
    {
        using var output = new MemoryStream();
        using var error = new StringWriter();
        using var streams = new StandardStreams(output, error, IsTerminal: true) { Columns = columns };

        // What is drawn without end keeps its thread for itself.
        int exitCode = await Task.Run(() => CommandLine.RunAsync(args, streams, TestContext.Current.CancellationToken))
            .WaitAsync(Limit, TestContext.Current.CancellationToken);
        return new ToolResult(exitCode, Lines(Encoding.UTF8.GetString(output.ToArray())), Lines(error.ToString()));
    }

    private static string[] Lines(string text) => text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
}
