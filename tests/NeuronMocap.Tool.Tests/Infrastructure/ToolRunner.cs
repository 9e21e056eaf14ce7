using System.Text;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Tests.Infrastructure;

/// <summary>The result of a run of the monitor.</summary>
internal sealed record ToolResult(int ExitCode, string[] Output, string[] Error)
{
    public string[] OfType(string type) => [.. Output.Where(line => line.StartsWith($"{{\"type\":\"{type}\"", StringComparison.Ordinal))];
}

/// <summary>Runs the monitor inside the test process, with its output in memory.</summary>
internal static class ToolRunner
{
    // Far longer than any run. A test that reaches it has failed.
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

    /// <summary>Runs as on a terminal with a given width.</summary>
    public static async Task<ToolResult> RunOnTerminalAsync(int columns, params string[] args)
    {
        using var output = new MemoryStream();
        using var error = new StringWriter();
        using var streams = new StandardStreams(output, error, IsTerminal: true) { Columns = columns };

        // Endless drawing keeps its own thread.
        int exitCode = await Task.Run(() => CommandLine.RunAsync(args, streams, TestContext.Current.CancellationToken))
            .WaitAsync(Limit, TestContext.Current.CancellationToken);
        return new ToolResult(exitCode, Lines(Encoding.UTF8.GetString(output.ToArray())), Lines(error.ToString()));
    }

    private static string[] Lines(string text) => text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
}
