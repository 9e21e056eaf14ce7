namespace NeuronMocap.Tool.Tests.Infrastructure;

/// <summary>An option that the help of a verb lists.</summary>
/// <param name="Name">With its dashes.</param>
/// <param name="MayStandAlone">Whether its value may be left out.</param>
internal sealed record VerbOption(string Name, bool MayStandAlone);

/// <summary>What the help of a verb says, so that tests look at options that come to be added.</summary>
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

    /// <summary>Words that a verb does not do without.</summary>
    public static string[] FilesOf(string verb) => verb switch
    {
        "play" or "info" => ["a.nmrec"],
        "convert" => ["a.bvh", "b.bvh"],
        "plot" => ["a.bvh", "b.svg"],
        "command" => ["demo"],
        "completion" => ["bash"],
        _ => [],
    };
}
