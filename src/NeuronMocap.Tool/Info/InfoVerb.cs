using System.CommandLine;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>neuron-mocap info: describes the contents of files.</summary>
internal sealed class InfoVerb : Verb
{
    private readonly Argument<string[]> _files = new("FILE")
    {
        Description = "A BVH file, a recording, a calculation export, or the raw bytes of a stream; its name does not matter.",
        Arity = ArgumentArity.OneOrMore,
    };

    private readonly Option<bool> _json = CommonOptions.Json("Print one JSON object a line, one line for each file.");
    private readonly Option<double?> _rate = CommonOptions.Rate();
    private readonly Option<int?> _avatar = CommonOptions.Avatar("For a recording: number of the avatar, from 0. Default: the first.");
    private readonly Option<int?> _sender = CommonOptions.Sender();
    private readonly Option<RotationOrder?> _order = CommonOptions.StreamOrder();

    public InfoVerb()
        : base("info", "Show the contents of files and what is unusual about them.")
    {
        Add(_files);
        AddOptions("Options", _json, _rate, _avatar, _sender, _order);
    }

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("info take.bvh", "joints, frames, and what is unusual about them"),
        new("info *.nmrec --json", "a line for another program for each recording"),
        new("info dump.bin --rate 60", "the raw bytes of a stream, at 60 frames per second"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes { get; } =
    [
        (ToolCommand.Done, "done"),
        (ToolCommand.NothingReceived, "a file could not be read; the others are shown"),
        (ToolCommand.Interrupted, "ended by Ctrl+C or SIGTERM"),
    ];

    public override async Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken)
    {
        bool isJson = result.GetValue(_json);
        string[] files = result.GetValue(_files)!;
        int exitCode = ToolCommand.Done;
        bool isFirst = true;
        foreach (string file in files)
        {
            var settings = new FileSettings(file, Output: null)
            {
                Json = isJson,
                FollowsAnother = !isFirst,
                InputRate = result.GetValue(_rate),
                Avatar = result.GetValue(_avatar),
                Sender = result.GetValue(_sender),
                InputOrder = result.GetValue(_order),
            };
            int ofFile = await new InfoTool(settings, streams).RunAsync(cancellationToken);
            isFirst &= ofFile != ToolCommand.Done;
            exitCode = Math.Max(exitCode, ofFile);
            if (ofFile == ToolCommand.Interrupted)
                break;
        }

        return exitCode;
    }
}
