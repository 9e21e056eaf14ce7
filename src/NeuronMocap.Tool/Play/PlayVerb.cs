using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch;
using NeuronMocap.Tool.Watch.Export;
using NeuronMocap.Tool.Watch.Playback;

namespace NeuronMocap.Tool.Play;

/// <summary>neuron-mocap play: plays a file as if it arrived now.</summary>
internal sealed class PlayVerb : Verb
{
    private readonly Argument<string> _file = new("FILE")
    {
        Description = "A recording (.nmrec), or a file with the raw bytes of a stream.",
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly PlaybackArguments _playback = new();
    private readonly OutputArguments _output = new(
        "Print every frame as one JSON object a line, and a summary at the end. No frame is left out: the playback waits for a slow reader of the output.");

    private readonly Option<RotationOrder?> _order = CommonOptions.Order(
        "--order", "Rotation order, if the file does not state it. Default: the order that the file states, or YXZ.");

    private readonly Option<bool> _overwrite = CommonOptions.Overwrite("the file of --export");
    private readonly ExportArguments _export = new("the file (displacement on)");

    public PlayVerb()
        : base("play", "Show a recording as if it arrived now. The keys of the live view pause it, move it and change its speed.")
    {
        Add(_file);
        AddOptions("Playback", [.. _playback.All, _order]);
        AddOptions("Output", _output.All);
        AddOptions("BVH export", [.. _export.All, _overwrite]);
        Validators.Add(Reject);
    }

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("play take.nmrec --speed 0.5", "half as fast"),
        new("play take.nmrec --loop", "in a loop"),
        new("play dump.bin --rate 60 --json", "frames from raw bytes, for another program"),
        new("play take.nmrec --speed max --quiet", "how many frames it has, and whether some are lost"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes => WatchVerb.Codes;

    public override (string Title, IReadOnlyList<string> Lines) Notes => LiveKeys.OfPlay;

    public override async Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken)
    {
        WatchOptions options = _output.Read(result, new ConnectionOptions { RotationOrder = result.GetValue(_order) }) with
        {
            Play = _playback.Read(result, result.GetValue(_file)!),
            Export = _export.Read(result, result.GetValue(_overwrite)),
        };
        return options.Connection.FindFault() is { } fault
            ? await RefuseAsync(streams, fault)
            : await new WatchRun(options, streams).RunAsync(cancellationToken);
    }

    private void Reject(CommandResult result)
    {
        _output.RejectContradictions(result);
        _export.RejectContradictions(result);
        if (IsGiven(result, _overwrite) && !IsGiven(result, _export.File))
            result.AddError("--overwrite needs --export: nothing else can be replaced.");

        SameFile.Reject(result, result.GetResult(_file) is { Tokens: [var file, ..] } ? ("FILE", file.Value) : null, _export.File);
    }
}
