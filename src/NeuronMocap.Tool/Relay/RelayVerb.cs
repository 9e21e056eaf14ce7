using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.AspNetCore;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Output;
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
            + "computer. ws:// listens for browsers and other WebSocket clients; without an address, only for this computer. udp:// sends to a computer. "
            + "vmc:// sends poses of one avatar to a program that shows it; osc:// sends poses of all as OSC messages. AVATAR is a name, or a number: digits "
            + $"always mean the number. Without a port, vmc:// means {Source.DefaultVmcPort}. "
            + "amqp:// publishes to a RabbitMQ broker; &stream=NAME keeps the take there. A file is written until the end.",
        Arity = ArgumentArity.OneOrMore,
        CustomParser = ParseDestinations,
    };

    private readonly ConnectionArguments _connection = new();
    private readonly PlaybackArguments _playback = new();
    private readonly PoseArguments _poses = new();
    private readonly Option<TimeSpan?> _duration = CommonOptions.Duration("End after this many seconds, as in 2.5; more than 0, at most 1000000.");
    private readonly Option<bool> _once = new("--once") { Description = "End when the connection to the source ends or cannot be made, instead of trying again." };
    private readonly Option<bool> _json = CommonOptions.Json(
        "Print what arrives and what goes to each destination once a second, and every event, as one JSON object a line. A slow reader of the output misses "
            + "lines; packets never wait for it.");

    private readonly Option<bool> _quiet = CommonOptions.Quiet();
    private readonly Option<bool> _overwrite = CommonOptions.Overwrite("files");
    private readonly Option<string?> _token = new("--token")
    {
        HelpName = "WORD",
        Description = "Clients of ws:// must send this word. In a query, write special characters percent-encoded, as in ?token=a%26b. Without TLS the network can read it.",
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<string[]> _allowOrigin = new("--allow-origin")
    {
        HelpName = "ORIGIN",
        Description = "Web site whose pages may connect to ws://, such as https://show.example; null for pages from files, * for all; may be repeated. Pages of this "
            + "computer always may.",
        Arity = ArgumentArity.OneOrMore,
    };

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
        _to.CompletionSources.Add(
            TcpDestination.Scheme + ":", WebSocketDestination.Scheme + ":", UdpDestination.Scheme, VmcDestination.Scheme, OscDestination.Scheme,
            RabbitMqDestination.Scheme);
        AddOptions("Output", _json, _quiet);
        AddOptions("Relay", _commands, _token, _allowOrigin, _duration, _once, _overwrite);
        AddOptions("With a destination vmc:// or osc://", _poses.All);
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
        new("relay 192.168.1.20 vmc://127.0.0.1:39539/0 vmc://127.0.0.1:39541/1", "two performers to two avatar programs"),
        new("relay 192.168.1.20 ws://:7100", "to pages in browsers on this computer"),
        new("relay studio amqp://user:password@broker?stage=main", "to every computer that asks a RabbitMQ broker for this stage"),
        new("relay take.nmrec tcp://127.0.0.1:7001 --loop", "a recording, for programs on this computer"),
        new("relay studio tcp://:7001 --json", "figures for another program, once a second"),
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
        Destination[] to = [.. _poses.Apply(result, result.GetValue(_to)!).Select(to => Guard(to, result))];
        var options = new RelayOptions(source, connection, to)
        {
            Play = source.File is { } file ? _playback.Read(result, file) : null,
            Commands = result.GetValue(_commands),
            Output = result.GetValue(_json) ? OutputKind.Json : result.GetValue(_quiet) ? OutputKind.Quiet : OutputKind.Person,
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

    private Destination Guard(Destination destination, ParseResult result) => destination is WebSocketDestination web
        ? web with { Token = result.GetValue(_token), AllowedOrigins = result.GetValue(_allowOrigin) ?? [] }
        : destination;

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
        RejectBoth(result, _json, _quiet);
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

    private void RejectGuards(CommandResult result, Destination[] all)
    {
        bool isWeb = Array.Exists(all, static to => to is WebSocketDestination);
        foreach (Option option in (Option[])[_token, _allowOrigin])
        {
            if (IsGiven(result, option) && !isWeb)
                result.AddError($"{option.Name} needs a destination ws://:PORT: it is for its clients.");
        }

        if (result.GetResult(_token)?.Tokens is [{ Value: var word }] && (word.Length == 0 || word.Trim().Length < word.Length || word.Any(char.IsControl)))
            result.AddError("--token: the word is empty, or has a line break or spaces around it.");
        foreach (Token origin in result.GetResult(_allowOrigin)?.Tokens ?? [])
        {
            if (!AllowedOrigin.IsValid(origin.Value))
                result.AddError($"--allow-origin: '{origin.Value}' is not an origin. Use a scheme and a host, such as https://show.example, or null, or *.");
        }
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

        Destination[] listening = [.. all.Where(static to => to.Listening is not null)];
        for (int i = 0; i < listening.Length; i++)
        {
            foreach (Destination other in listening[(i + 1)..].Where(other => !listening[i].IsSame(other) && TcpDestination.Clashes(listening[i].Listening!, other.Listening!)))
                result.AddError($"{listening[i].Text} and {other.Text} need different ports.");
        }

        if (Find(result.GetResult(_commands)?.Tokens) is [TcpDestination commands]
            && Array.Find(listening, to => TcpDestination.Clashes(commands.EndPoint, to.Listening!)) is { } taken)
        {
            result.AddError($"--commands and {taken.Text} need different ports.");
        }

        RejectGuards(result, all);
        _poses.Reject(result, all);
        if (IsGiven(result, _overwrite) && Array.TrueForAll(all, static to => to.File is null))
            result.AddError("--overwrite needs a file to write: nothing else can be replaced.");
    }
}
