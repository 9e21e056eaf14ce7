using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Diagnose;

/// <summary>neuron-mocap diagnose: finds out why no frames arrive.</summary>
internal sealed class DiagnoseVerb : Verb
{
    private const string ThisComputer = "127.0.0.1";
    private const double Shortest = 1;
    private const double Longest = 300;

    private readonly SourceArgument _source = new("What to diagnose", Source.ConnectionForms, "this computer, TCP port 7001");
    private readonly ConnectionArguments _connection = new();
    private readonly Option<bool> _json = CommonOptions.Json("Print every step and the result as one JSON object a line.");
    private readonly Option<bool> _quiet = new("--quiet") { Description = "Print only the result, as one JSON object." };

    private readonly Option<TimeSpan?> _duration = new("--duration")
    {
        HelpName = "SECONDS",
        Description = $"Take no longer than this, {Shortest} to {Longest} seconds. Default: 10.",
        CustomParser = static result => NumberArgument.Parse(result, Shortest, Longest, "a number of seconds from 1 to 300") is { } seconds
            ? TimeSpan.FromSeconds(seconds)
            : null,
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<RotationOrder?> _order = CommonOptions.Order("--order", "Rotation order that the server is set to. Default: YXZ.");

    private readonly Option<ServerAddress?> _server = new("--server")
    {
        HelpName = "HOST",
        Description = "With udp://: the computer that should send, to check whether it offers the stream over TCP instead. Default: this computer.",
        CustomParser = static result => ParseServer(result),
        Arity = ArgumentArity.ExactlyOne,
    };

    public DiagnoseVerb()
        : base(
            "diagnose",
            "Check a stream once, step by step, and report what is wrong and which setting of Axis Neuron or Axis Studio to change. It takes 10 seconds at most, or as long as --duration allows.")
    {
        Add(_source);
        AddOptions("Output", _json, _quiet, _duration);
        AddOptions("Connection", [_order, .. _connection.All, _server]);
        Validators.Add(Reject);
    }

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("diagnose 192.168.1.20", "no data from this computer? What is wrong, and which setting to change"),
        new("diagnose", "the same for a server on this computer"),
        new("diagnose udp://:7012", "the same for UDP"),
        new("diagnose demo", "what a healthy stream looks like"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes { get; } =
    [
        (ToolCommand.Done, "frames arrive"),
        (ToolCommand.NothingReceived, "no frames arrive"),
        (ToolCommand.Interrupted, "ended by Ctrl+C or SIGTERM before the result"),
    ];

    public override async Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken)
    {
        Source source = result.GetValue(_source) ?? Source.OfServer(new ServerAddress(ThisComputer, ProtocolConstants.DefaultPort));
        ConnectionOptions options = _connection.Read(result, source) with { RotationOrder = result.GetValue(_order), Duration = result.GetValue(_duration) };
        if (source.Kind == SourceKind.Udp)
            options = options with { Server = result.GetValue(_server) ?? new ServerAddress(ThisComputer, ProtocolConstants.DefaultPort) };

        OutputKind output = result.GetValue(_json) ? OutputKind.Json : result.GetValue(_quiet) ? OutputKind.Quiet : OutputKind.Person;
        return options.FindFault() is { } fault
            ? await RefuseAsync(streams, fault)
            : await new DiagnosisRun(options, output, streams).RunAsync(cancellationToken);
    }

    private void Reject(CommandResult result)
    {
        RejectBoth(result, _json, _quiet);
        Source source = _source.Find(result) ?? Source.OfServer(default);
        if (source.Kind == SourceKind.File)
        {
            result.AddError($"'{source}' is a file and has no connection to diagnose; {ToolCommand.Name} info {source} shows its contents.");
            return;
        }

        if (source.Kind == SourceKind.RabbitMq)
        {
            result.AddError($"'{source}' is a broker, which has no steps to diagnose; {ToolCommand.Name} watch '{source}' says what is wrong with it.");
            return;
        }

        _connection.RejectContradictions(result, source);
        if (IsGiven(result, _server) && source.Kind != SourceKind.Udp)
            result.AddError("--server needs a source udp://:PORT: any other source names the server itself.");
    }

    private static ServerAddress? ParseServer(ArgumentResult result)
    {
        try
        {
            return ServerAddress.Parse(result.Tokens[0].Value);
        }
        catch (FormatException fault)
        {
            result.AddError($"--server: {fault.Message}");
            return null;
        }
    }
}
