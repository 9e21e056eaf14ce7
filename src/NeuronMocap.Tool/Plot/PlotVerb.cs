using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Plot;

/// <summary>neuron-mocap plot: draws a plot of a file.</summary>
internal sealed class PlotVerb : Verb
{
    private const string Extension = ".svg";

    private readonly TakeArguments _take = new("OUT.svg", "The picture to write.");

    public PlotVerb()
        : base("plot", "Draw a file as a picture. It shows skeletons at regular times, the path over the ground, heights of the feet and speeds.")
    {
        foreach (Argument file in _take.Files)
            Add(file);

        AddOptions("Options", _take.Options);
        Validators.Add(Reject);
    }

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("plot take.bvh take.svg", "a picture of a take"),
        new("plot take.nmrec take.svg --from 2 --to 5 --avatar 1", "three seconds of the second avatar"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes => TakeArguments.Codes;

    public override Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken) =>
        new PlotTool(_take.Read(result), streams).RunAsync(cancellationToken);

    private void Reject(CommandResult result)
    {
        _take.RejectContradictions(result);
        if (_take.FindOutput(result) is { } output && !output.EndsWith(Extension, StringComparison.OrdinalIgnoreCase))
            result.AddError($"the name '{output}' does not end with {Extension}, the only kind of picture.");
    }
}
