using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.View;

/// <summary>neuron-mocap view: shows a stream or a take in the browser.</summary>
internal sealed class ViewVerb : Verb
{
    private readonly SourceArgument _source = new("What to show", Source.Forms, "demo");
    private readonly ConnectionArguments _connection = new();
    private readonly ViewArguments _view = new();
    private readonly Option<TimeSpan?> _duration = CommonOptions.Duration("End after this many seconds, as in 2.5; more than 0, at most 1000000.");
    private readonly Option<RotationOrder?> _order = CommonOptions.Order(
        "--order",
        "Rotation order, a setting of the server. Default: the order in the stream (Axis Studio only), or that of the command channel "
            + "(--command-port), or YXZ.");

    public ViewVerb()
        : base("view", "Show a stream or a take in the browser: performers in three dimensions, the state of the stream, recording and takes with a time line.")
    {
        Add(_source);
        AddOptions("Page", [.. _view.All, _duration]);
        AddOptions("Connection", [_order, .. _connection.All]);
        Validators.Add(Reject);
    }

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("view", "a moving skeleton, without suit or server"),
        new("view 192.168.1.20 --open", "Axis Neuron on another computer, and start the browser"),
        new("view udp://:7012", "Axis Neuron set to UDP, with this computer as destination"),
        new("view 192.168.1.20 --command-port 8013", "with commands, such as zero-out, from the page"),
        new("view take.nmrec", "a take, with a time line"),
        new("view demo --bind 0.0.0.0", "for a phone or another computer, by a link or a QR code"),
        new("view studio --port 8080 --record-folder takes", "another port, and recordings in a folder"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes { get; } =
    [
        (ToolCommand.Done, "ended by Ctrl+C, SIGTERM or --duration"),
        (ToolCommand.NothingReceived, "the port is not available, or a file could not be read or written"),
    ];

    public override async Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken)
    {
        Source source = result.GetValue(_source) ?? Source.Demo;
        ConnectionOptions connection = _connection.Read(result, source) with { RotationOrder = result.GetValue(_order), Duration = result.GetValue(_duration) };
        ViewOptions options = _view.Read(result, new ViewOptions(source, connection));
        if ((connection.FindFault() ?? options.FindFault()) is { } fault)
            return await RefuseAsync(streams, fault);

        FirstUse.Start();
        return await new ViewRun(options, streams).RunAsync(cancellationToken);
    }

    private void Reject(CommandResult result)
    {
        Source source = _source.Find(result) ?? Source.Demo;
        _connection.RejectContradictions(result, source);
        _view.Reject(result, source);
    }
}
