namespace NeuronMocap.Tool.Tests.Infrastructure;

/// <summary>An option that the help of a verb lists.</summary>
/// <param name="Name">The name, with its dashes.</param>
/// <param name="MayStandAlone">Whether its value is optional.</param>
internal sealed record VerbOption(string Name, bool MayStandAlone);

/// <summary>Reads the help of a verb, so that tests also cover options added later.</summary>
internal static class VerbHelp
{
    /// <summary>The options that take a value.</summary>
    public static async Task<IReadOnlyList<VerbOption>> ReadAsync(string verb)
    {
        ToolResult help = await ToolRunner.RunAsync(verb, "--help");
        return
        [
            .. help.Output
                .Where(static line => line.StartsWith("  --", StringComparison.Ordinal))
                .Select(static line => line.Trim().Split("  ")[0])
                .Where(static label => label.Contains('<', StringComparison.Ordinal))
                .Select(static label => new VerbOption(label.Split(' ', ',')[0], label.Contains("[<", StringComparison.Ordinal))),
        ];
    }

    /// <summary>Arguments that a verb requires.</summary>
    public static string[] FilesOf(string verb) => verb switch
    {
        "play" or "info" => ["a.nmrec"],
        "convert" => ["a.bvh", "b.bvh"],
        "plot" => ["a.bvh", "b.svg"],
        "relay" => ["studio", "tcp://:0"],
        "command" => ["demo"],
        "completion" => ["bash"],
        _ => [],
    };
}
