using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Watch;

/// <summary>The options for the format and the duration of the output.</summary>
internal sealed class OutputArguments
{
    private readonly Option<bool> _json = CommonOptions.Json(
        "Print every frame and every change of the connection as one JSON object a line, and a summary at the end. No frame is left out: over TCP the server "
            + "waits for a slow reader of the output.");

    private readonly Option<bool> _quiet = CommonOptions.Quiet();
    private readonly Option<long?> _frames = CommonOptions.Frames();
    private readonly Option<TimeSpan?> _duration = CommonOptions.Duration("End after this many seconds, as in 2.5; more than 0, at most 1000000.");

    public Option[] All => [_json, _quiet, _frames, _duration];

    public void RejectContradictions(CommandResult result) => Verb.RejectBoth(result, _json, _quiet);

    /// <summary>Creates watch options with only these settings.</summary>
    public WatchOptions Read(ParseResult result) => new()
    {
        Frames = result.GetValue(_frames),
        Duration = result.GetValue(_duration),
        Output = result.GetValue(_json) ? OutputKind.Json : result.GetValue(_quiet) ? OutputKind.Quiet : OutputKind.Person,
    };
}
