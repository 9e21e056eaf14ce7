using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch.Export;
using NeuronMocap.Tool.Watch.Playback;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Watch;

/// <summary>neuron-mocap watch: shows the frames of a source.</summary>
internal sealed class WatchVerb : Verb
{
    private readonly SourceArgument _source = new("What to receive from", Source.Forms, "demo");
    private readonly ConnectionArguments _connection = new();
    private readonly PlaybackArguments _playback = new();
    private readonly OutputArguments _output = new(
        "Print every frame and every change of the connection as one JSON object a line, and a summary at the end. No frame is left out: over TCP the server "
            + "waits for a slow reader of the output.");

    private readonly ExportArguments _export = new("the stream (displacement on), from the server's command channel");
    private readonly RecordingArguments _recording = new();
    private readonly Option<bool> _overwrite = CommonOptions.Overwrite("the files of --record and --export");
    private readonly Option<bool> _once = new("--once") { Description = "End when the connection ends or cannot be made, instead of trying again." };

    private readonly Option<RotationOrder?> _order = CommonOptions.Order(
        "--order",
        "Rotation order, a setting of the server. Default: the order in the stream (Axis Studio only), or that of the command channel "
            + "(--command-port), or YXZ.");

    public WatchVerb()
        : base(
            "watch",
            "Show the frames of a source. A terminal shows a live view with the skeleton, rates and losses; otherwise one plain line a second. Positions are in "
            + "centimetres, angles in degrees.")
    {
        Add(_source);
        AddOptions("Output", [.. _output.All, _once]);
        AddOptions("Connection", [_order, .. _connection.All]);
        AddOptions("Recording", _recording.All);
        AddOptions("BVH export", [.. _export.All, _overwrite]);
        AddOptions("With a file as the source", _playback.All);
        Validators.Add(Reject);
    }

    /// <summary>The meaning of the exit codes of this verb and of play.</summary>
    public static IReadOnlyList<(int Code, string Meaning)> Codes { get; } =
    [
        (ToolCommand.Done, "success, or ended by q, Ctrl+C or SIGTERM"),
        (ToolCommand.NothingReceived, "nothing was received, or a file could not be read or written; standard error says which setting to check"),
    ];

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("watch", "a moving skeleton, without suit or server"),
        new("watch 192.168.1.20", "Axis Neuron on another computer, TCP port 7001"),
        new("watch [::1]:7003 --order XYZ", "IPv6, another port, another rotation order"),
        new("watch udp://:7012", "Axis Neuron set to UDP, with this computer as destination"),
        new("watch udp://192.168.1.5:7012", "the same on one network of several; 192.168.1.5 is this computer"),
        new("watch udp://:7012 --allow-sender 192.168.1.20", "the same, only from this sender"),
        new("watch vmc://:39539", "poses of a program that sends VMC to this computer"),
        new("watch 192.168.1.20 --calculation-port 7003", "calculation data as well, from their own port"),
        new("watch amqp://user:password@broker?stage=main", "a stage on a RabbitMQ broker"),
        new("watch take.nmrec", "a recording, as play does"),
        new("watch studio --record take.nmrec", "show the stream and record every byte"),
        new("watch studio --export take.bvh", "show the stream and export it as BVH, until q or Ctrl+C"),
        new("watch studio --json --frames 100", "100 frames for another program"),
        new("watch studio --quiet --duration 10", "does anything arrive? The exit code says it"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes => Codes;

    public override (string Title, IReadOnlyList<string> Lines) Notes => LiveKeys.OfWatch;

    public override async Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken)
    {
        bool overwrite = result.GetValue(_overwrite);
        Source source = result.GetValue(_source) ?? Source.Demo;
        ConnectionOptions connection = _connection.Read(result, source) with { RotationOrder = result.GetValue(_order), Once = result.GetValue(_once) };
        WatchOptions options = _output.Read(result, connection) with
        {
            Play = source.File is { } file ? _playback.Read(result, file) : null,
            Recording = _recording.Read(result, overwrite),
            Export = _export.Read(result, overwrite),
        };
        return options.Connection.FindFault() is { } fault
            ? await RefuseAsync(streams, fault)
            : await new WatchRun(options, streams).RunAsync(cancellationToken);
    }

    private void Reject(CommandResult result)
    {
        Source source = _source.Find(result) ?? Source.Demo;
        _output.RejectContradictions(result);
        _connection.RejectContradictions(result, source);
        _export.RejectContradictions(result);
        _recording.RejectContradictions(result);
        if (source.File is null)
            _playback.Reject(result);
        else
            RejectForFile(result, source.File);

        SameFile.Reject(result, null, _export.File, _recording.File);
        if (IsGiven(result, _overwrite) && !IsGiven(result, _export.File) && !IsGiven(result, _recording.File))
            result.AddError("--overwrite needs --export or --record: nothing else can be replaced.");
    }

    private void RejectForFile(CommandResult result, string file)
    {
        if (IsGiven(result, _once))
            result.AddError("--once is for a connection: a file is read to its end.");
        if (IsGiven(result, _recording.File))
            result.AddError($"--record: the source is already a file; {ToolCommand.Name} convert copies it, or a part of it.");

        SameFile.Reject(result, ("SOURCE", file), _export.File);
    }
}
