using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Output;

namespace NeuronMocap.Tool.Watch;

/// <summary>The options for the format and the duration of the output.</summary>
internal sealed class OutputArguments
{
    private readonly Option<bool> _json;
    private readonly Option<bool> _quiet = CommonOptions.Quiet();
    private readonly Option<long?> _frames = CommonOptions.Frames();
    private readonly Option<TimeSpan?> _duration = CommonOptions.Duration("End after this many seconds, as in 2.5; more than 0, at most 1000000.");

    /// <summary>Creates the options.</summary>
    /// <param name="contents">What --json prints, and what a slow reader of the output has to expect.</param>
    public OutputArguments(string contents) => _json = CommonOptions.Json(contents);

    public Option[] All => [_json, _quiet, _frames, _duration];

    public void RejectContradictions(CommandResult result) => Verb.RejectBoth(result, _json, _quiet);

    /// <summary>Creates the options of a run.</summary>
    /// <param name="result">A command line without errors.</param>
    /// <param name="connection">The connection, without its duration.</param>
    public WatchOptions Read(ParseResult result, ConnectionOptions connection) => new()
    {
        Connection = connection with { Duration = result.GetValue(_duration) },
        Frames = result.GetValue(_frames),
        Output = result.GetValue(_json) ? OutputKind.Json : result.GetValue(_quiet) ? OutputKind.Quiet : OutputKind.Person,
    };
}
