using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Relay.Destinations;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch.Playback;

namespace NeuronMocap.Tool.Relay;

/// <summary>neuron-mocap relay: sends what arrives on to other programs and files.</summary>
internal sealed class RelayVerb : Verb
{
    private readonly SourceArgument _source = new("What to receive from", Source.Forms, whenLeftOut: null);
    private readonly Argument<Destination[]> _to = new("TO")
    {
        Description = $"Where packets go, once or more: {Destination.Forms}. tcp:// listens for clients on this computer; without an address, for every "
            + "computer. udp:// sends to a computer. amqp:// publishes to a RabbitMQ broker; &stream=NAME keeps the take there. A file is written until the end.",
        Arity = ArgumentArity.OneOrMore,
        CustomParser = ParseDestinations,
    };

    private readonly ConnectionArguments _connection = new();
    private readonly PlaybackArguments _playback = new();
    private readonly Option<TimeSpan?> _duration = CommonOptions.Duration("End after this many seconds, as in 2.5; more than 0, at most 1000000.");
    private readonly Option<bool> _once = new("--once") { Description = "End when the connection to the source ends or cannot be made, instead of trying again." };
    private readonly Option<bool> _overwrite = CommonOptions.Overwrite("files");
    private readonly Option<TcpDestination?> _commands = new("--commands")
    {
        HelpName = "tcp://[ADDRESS]:PORT",
        Description = "Listen here for clients of the command channel, and pass their commands to the source (--command-port, usually "
            + $"{ProtocolConstants.DefaultCommandPort}). Every client can zero out the avatars.",
        CustomParser = ParseCommands,
        Arity = ArgumentArity.ExactlyOne,
    };

    public RelayVerb()
        : base("relay", "Send what arrives on to other programs and files, bit for bit. A destination that is slow or gone costs the others nothing.")
    {
        Add(_source);
        Add(_to);
        _to.CompletionSources.Add(TcpDestination.Scheme + ":", UdpDestination.Scheme, RabbitMqDestination.Scheme);
        AddOptions("Relay", _commands, _duration, _once, _overwrite);
        AddOptions("Connection", _connection.All);
        AddOptions("With a file as the source", _playback.All);
        Validators.Add(Reject);
    }

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("relay 192.168.1.20 tcp://:7001", "other computers connect to this one, as if it ran Axis Neuron"),
        new("relay 192.168.1.20 tcp://:7001 --commands tcp://:8013", "the same, with the command channel"),
        new("relay udp://:7012 udp://192.168.1.31:7012 udp://192.168.1.32:7012", "datagrams to two computers"),
        new("relay studio tcp://:7001 take.nmrec take.bvh", "to other computers, to a recording and to a BVH file"),
        new("relay studio amqp://user:password@broker?stage=main", "to every computer that asks a RabbitMQ broker for this stage"),
        new("relay take.nmrec tcp://127.0.0.1:7001 --loop", "a recording, for programs on this computer"),
        new("relay demo tcp://:7001", "a moving skeleton for every computer of the network"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes { get; } =
    [
        (ToolCommand.Done, "success, or ended by Ctrl+C or SIGTERM"),
        (ToolCommand.NothingReceived, "nothing was received, a destination is not available, or a file could not be read or written"),
    ];

    public override async Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken)
    {
        Source source = result.GetValue(_source)!;
        ConnectionOptions connection = _connection.Read(result, source) with { Once = result.GetValue(_once), Duration = result.GetValue(_duration) };
        var options = new RelayOptions(source, connection, result.GetValue(_to)!)
        {
            Play = source.File is { } file ? _playback.Read(result, file) : null,
            Commands = result.GetValue(_commands),
            Overwrite = result.GetValue(_overwrite),
        };
        return connection.FindFault() is { } fault
            ? await RefuseAsync(streams, fault)
            : await new RelayRun(options, streams).RunAsync(cancellationToken);
    }

    private static Destination[] ParseDestinations(ArgumentResult result)
    {
        var destinations = new List<Destination>();
        foreach (Token token in result.Tokens)
        {
            if (Destination.TryParse(token.Value, out Destination? destination, out string? error))
                destinations.Add(destination);
            else
                result.AddError(error);
        }

        return [.. destinations];
    }

    private static TcpDestination? ParseCommands(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (Destination.TryParse(text, out Destination? destination, out string? error) && destination is TcpDestination tcp)
            return tcp;

        result.AddError($"--commands: {error ?? $"'{text}' is not a place to listen. Use tcp://:PORT."}");
        return null;
    }

    private void Reject(CommandResult result)
    {
        if (_source.Find(result) is not { } source)
            return;

        _connection.RejectContradictions(result, source);
        if (source.File is null)
            _playback.Reject(result);
        else if (IsGiven(result, _once))
            result.AddError("--once is for a connection: a file is read to its end.");
        if (result.GetResult(_playback.Speed)?.Tokens is [{ Value: var speed }] && speed.Equals("max", StringComparison.OrdinalIgnoreCase))
            result.AddError("--speed max is faster than clients read: give a number.");
        if (IsGiven(result, _commands) && source.Kind != SourceKind.Tcp)
            result.AddError("--commands needs a source HOST or tcp://HOST:PORT: commands go to another port of that server.");

        RejectDestinations(result, source);
    }

    // Words that are no destination have their own error.
    private static Destination[] Find(IReadOnlyList<Token>? words) =>
        [.. (words ?? []).Select(static word => Destination.TryParse(word.Value, out Destination? found, out _) ? found : null).OfType<Destination>()];

    private void RejectDestinations(CommandResult result, Source source)
    {
        Destination[] all = Find(result.GetResult(_to)?.Tokens);
        foreach (Destination loop in all.Where(to => RelayLoop.Exists(source, to)))
            result.AddError($"{loop.Text} would send the source {source} to itself. Choose another {(loop is RabbitMqDestination ? "stage" : loop.File is null ? "port" : "file")}.");

        for (int i = 0; i < all.Length; i++)
        {
            foreach (Destination same in all[(i + 1)..].Where(all[i].IsSame))
                result.AddError($"{all[i].Text} and {same.Text} are the same destination.");
        }

        if (Find(result.GetResult(_commands)?.Tokens) is [TcpDestination commands] && Array.Find(all, commands.IsSame) is { } taken)
            result.AddError($"--commands and {taken.Text} need different ports.");
        if (IsGiven(result, _overwrite) && Array.TrueForAll(all, static to => to.File is null))
            result.AddError("--overwrite needs a file to write: nothing else can be replaced.");
    }
}
