using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Commands;
using NeuronMocap.Tool.Diagnose;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Play;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch;
using NeuronMocap.Tool.Watch.Export;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool;

/// <summary>The options, their help and their errors.</summary>
internal sealed class CommandLine
{
    public const int Done = 0;
    public const int NothingReceived = 1;
    public const int BadUsage = 2;
    public const int Interrupted = 130;

    private const string Name = "neuron-mocap";
    private const double LongestDuration = 1_000_000;

    private static readonly string[] Orders = Enum.GetNames<RotationOrder>();

    private readonly Argument<SourceAddress?> _source = new("SOURCE")
    {
        Description = "What to receive from: HOST, HOST:PORT, tcp://HOST:PORT or udp://:PORT; short for --connect and --udp.",
        Arity = ArgumentArity.ZeroOrOne,
        CustomParser = ParseSource,
    };

    private readonly Option<ServerAddress?> _connect = new("--connect")
    {
        HelpName = "HOST[:PORT]",
        Description = "Receive over TCP from this server: a name, an IPv4 address, or an IPv6 address in brackets. "
            + $"Port 1 to 65535; default {ProtocolConstants.DefaultPort}.",
        CustomParser = ParseServer,
    };

    private readonly Option<int?> _udp = new("--udp")
    {
        HelpName = "PORT",
        Description = "Receive over UDP on this port of this computer, 1 to 65535.",
        CustomParser = result => Parse<int?>(
            result, text => ServerAddress.TryParsePort(text, out int port) ? port : null, $"a number from 1 to {IPEndPoint.MaxPort}"),
    };

    private readonly Option<IPAddress[]> _allowSender = new("--allow-sender")
    {
        HelpName = "ADDRESS",
        Description = "With --udp: let only this address send, and drop the datagrams of all others; may be repeated. Default: everyone may.",
        CustomParser = ParseAddresses,
    };

    private readonly Option<IPAddress?> _localAddress = new("--local-address")
    {
        HelpName = "ADDRESS",
        Description = "Of a computer with several networks: connect from this address of it, or receive UDP on it only. Default: over TCP as the system "
            + "chooses, over UDP all IPv4 addresses.",
        CustomParser = static result => Parse<IPAddress?>(
            result, static text => IPAddress.TryParse(text, out IPAddress? address) ? address : null, "an IP address"),
    };

    private readonly Option<bool> _demo = new("--demo")
    {
        Description = "Receive from a simulator inside this program. This is the default.",
    };

    private readonly Option<ServerAddress?> _diagnose = new("--diagnose")
    {
        HelpName = "HOST[:PORT]",
        Description = "No data? Look at this server once, step by step, and say what is wrong and which setting of Axis Neuron or Axis Studio "
            + "to change. Without HOST[:PORT]: the server of --connect or --demo, the port of --udp, or this computer. Takes 10 s at most, "
            + "or as long as --duration says.",
        CustomParser = result => ParseServer(result),
        Arity = ArgumentArity.ZeroOrOne,
    };

    private readonly Option<RotationOrder?> _order = new("--order")
    {
        HelpName = string.Join('|', Orders),
        Description = "Order of the rotation values, a setting of the server. Default: what the stream says, which only Axis Studio's does, or the command channel (--command-port), or YXZ. With --convert: the order to write; --input-order is that of the stream.",
        CustomParser = result => Parse<RotationOrder?>(
            result,
            text => Array.FindIndex(Orders, name => name.Equals(text, StringComparison.OrdinalIgnoreCase)) is >= 0 and var index
                ? Enum.GetValues<RotationOrder>()[index]
                : null,
            $"one of {string.Join(", ", Orders)}"),
    };

    private readonly Option<int?> _commandPort = new("--command-port")
    {
        HelpName = "PORT",
        Description = "With --connect: ask the server's command channel on this port for the rotation order and the names of the bones, which most "
            + "streams do not say. Usually 8013; --commands shows all that it tells.",
        CustomParser = result => Parse<int?>(
            result, text => ServerAddress.TryParsePort(text, out int port) ? port : null, $"a number from 1 to {IPEndPoint.MaxPort}"),
    };

    private readonly Option<int?> _calculationPort = new("--calculation-port")
    {
        HelpName = "PORT",
        Description = "With --connect or --udp: receive calculation data as well, from this port of the server, over UDP on this port of this computer. "
            + $"Usually {ProtocolConstants.DefaultCalculationPort}.",
        CustomParser = result => Parse<int?>(
            result, text => ServerAddress.TryParsePort(text, out int port) ? port : null, $"a number from 1 to {IPEndPoint.MaxPort}"),
    };

    private readonly Option<bool> _once = new("--once")
    {
        Description = "End when the connection ends or cannot be made, instead of trying again.",
    };

    private readonly Option<long?> _frames = new("--frames")
    {
        HelpName = "N",
        Description = "End after N frames, motion and calculation together; N is 1 or more.",
        CustomParser = result => Parse<long?>(
            result,
            text => long.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out long frames) && frames > 0 ? frames : null,
            "a whole number of 1 or more"),
    };

    private readonly Option<TimeSpan?> _duration = new("--duration")
    {
        HelpName = "SECONDS",
        Description = "End after this many seconds, as in 2.5; more than 0, at most 1000000.",
        CustomParser = result => Parse<TimeSpan?>(
            result,
            text => double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double seconds)
                && seconds is > 0 and <= LongestDuration
                    ? TimeSpan.FromSeconds(seconds)
                    : null,
            "a number of seconds, more than 0 and at most 1000000"),
    };

    private readonly Option<bool> _json = new("--json")
    {
        Description = "Print every frame and every change of the connection as one JSON object a line, and a summary at the end. "
            + "No frame is left out: over TCP the server waits for a slow reader of the output.",
    };

    private readonly Option<bool> _quiet = new("--quiet")
    {
        Description = "Print nothing but the summary at the end, as one JSON object.",
    };

    private readonly Option<bool> _overwrite = new("--overwrite")
    {
        Description = "Replace files that are there; else they are an error.",
    };

    private readonly CommandArguments _commands = new();
    private readonly ExportArguments _export;
    private readonly FileArguments _files;

    private readonly RecordingArguments _recording = new();
    private readonly PlayArguments _play = new();

    private readonly RootCommand _root = new(
        "Shows what a Perception Neuron server (Axis Neuron, Axis Studio or a simulator) sends: on a terminal live, with the skeleton, "
        + "rates and losses; redirected, as one plain line a second. Positions are centimetres, angles degrees.");

    private CommandLine()
    {
        _root.Arguments.Add(_source);
        foreach (Option option in (Option[])[_connect, _udp, _allowSender, _localAddress, _demo, _diagnose, _order, _commandPort, _calculationPort, _once, _frames, _duration, _json, _quiet, _overwrite])
        {
            if (option == _allowSender)
                option.Arity = ArgumentArity.OneOrMore;
            else if (option != _diagnose)
                option.Arity = option.ValueType == typeof(bool) ? ArgumentArity.Zero : ArgumentArity.ExactlyOne;

            _root.Options.Add(option);
        }

        _commands.AddTo(_root);
        _play.AddTo(_root);
        _export = new ExportArguments(_overwrite);
        _export.AddTo(_root);
        _recording.AddTo(_root);
        _files = new FileArguments(_overwrite);
        _files.AddTo(_root);

        _root.Validators.Add(RejectContradictions);
        HelpExamples.AddTo(_root);
    }

    public static async Task<int> RunAsync(IReadOnlyList<string> args, StandardStreams streams, CancellationToken cancellation)
    {
        var commandLine = new CommandLine();
        ParseResult result;
        try
        {
            result = commandLine._root.Parse(args, new ParserConfiguration { ResponseFileTokenReplacer = null });
        }
        catch (Exception exception)
        {
            // The parser asks this program's own checks, and whatever they throw is no reason for a stack trace.
            return await RefuseAsync(UsageFault.WithHelp(Name, $"the options cannot be understood: {exception.Message}"), streams);
        }

        if (UsageFault.Find(result, Name, commandLine._source) is { } fault)
            return await RefuseAsync(fault, streams);

        int exitCode = Done;
        commandLine._root.SetAction(async _ => exitCode = await RunAsync(commandLine.Read(result), streams, cancellation));
        using var output = new StreamWriter(streams.Output, leaveOpen: true);
        var invocation = new InvocationConfiguration
        {
            Output = output,
            Error = streams.Error,
            EnableDefaultExceptionHandler = false,
            ProcessTerminationTimeout = null,
        };
        try
        {
            await result.InvokeAsync(invocation, CancellationToken.None);
            return exitCode;
        }
        catch (Exception exception)
        {
            // What nobody has thought of. The process ends with a sentence all the same, and the first line of the trace says where to look.
            string? place = exception.StackTrace?.Split('\n')[0].Trim();
            await streams.Error.WriteLineAsync(TerminalText.Clean($"{Name}: a fault of this program, please report it: {exception.GetType().Name}: {exception.Message} {place}"));
            return NothingReceived;
        }
    }

    private static Task<int> RunAsync(MonitorOptions options, StandardStreams streams, CancellationToken cancellation) => options switch
    {
        _ when options.FindFault() is { } fault => RefuseAsync(UsageFault.WithHelp(Name, fault), streams),
        { Files: { } files } => new FileRun(files, streams).RunAsync(cancellation),
        { Commands: { } commands } => new CommandRun(options, commands, streams).RunAsync(cancellation),
        { Diagnose: true } => new DiagnosisRun(options, streams).RunAsync(cancellation),
        _ => new MonitorRun(options, streams).RunAsync(cancellation),
    };

    private static async Task<int> RefuseAsync(string fault, StandardStreams streams)
    {
        await streams.Error.WriteLineAsync($"{Name}: {fault}");
        return BadUsage;
    }

    private static SourceAddress? ParseSource(ArgumentResult result)
    {
        if (result.Tokens.Count == 0)
            return null;

        string text = result.Tokens[0].Value;
        if (File.Exists(text))
        {
            result.AddError($"'{text}' is a file: --play {text} shows it, --info {text} says what it holds.");
            return null;
        }

        if (!SourceAddress.TryParse(text, out SourceAddress source, out string? error))
            result.AddError(error);
        else if (FileKinds.OfName(text) is not null)
            result.AddError($"'{text}' is the name of a file, and no such file is here. --connect {text} takes it for the name of a computer.");
        else
            return source;

        return null;
    }

    private static ServerAddress? ParseServer(ArgumentResult result)
    {
        if (result.Tokens.Count == 0)
            return null;
        if (ServerAddress.TryParse(result.Tokens[0].Value, out ServerAddress address, out string? error))
            return address;

        result.AddError($"{((OptionResult)result.Parent!).Option.Name}: {error}");
        return null;
    }

    private static IPAddress[]? ParseAddresses(ArgumentResult result)
    {
        var addresses = new List<IPAddress>();
        foreach (Token token in result.Tokens)
        {
            if (IPAddress.TryParse(token.Value, out IPAddress? address))
                addresses.Add(address);
            else
                result.AddError($"--allow-sender: '{token.Value}' is not an IP address.");
        }

        return [.. addresses];
    }

    private static T? Parse<T>(ArgumentResult result, Func<string, T?> parse, string expected)
    {
        string text = result.Tokens[0].Value;
        T? value = parse(text);
        if (value is null)
            result.AddError($"{((OptionResult)result.Parent!).Option.Name}: '{text}' is not {expected}.");

        return value;
    }

    private void RejectContradictions(CommandResult result)
    {
        RejectBesideSource(result);
        Option[] sources = [.. ((Option[])[_connect, _udp, _demo]).Where(option => IsGiven(result, option))];
        if (sources.Length > 1)
            result.AddError($"{sources[0].Name} and {sources[1].Name} exclude each other: there is one server.");
        if (IsGiven(result, _diagnose))
            RejectForDiagnosis(result);
        if (IsGiven(result, _allowSender) && !IsGiven(result, _udp) && SourceOf(result)?.UdpPort is null)
            result.AddError("--allow-sender needs --udp: over TCP the data comes from the server that --connect names.");
        if (IsGiven(result, _commandPort) && !IsGiven(result, _connect) && SourceOf(result)?.Server is null)
            result.AddError("--command-port needs --connect: it is a port of the server that --connect names.");
        if (IsGiven(result, _localAddress) && !((Option[])[_connect, _udp, _diagnose]).Any(option => IsGiven(result, option)) && SourceOf(result) is null)
            result.AddError("--local-address needs --connect, --udp or a source: it is the end of that connection on this computer.");
        if (IsGiven(result, _calculationPort) && !((Option[])[_connect, _udp, _diagnose]).Any(option => IsGiven(result, option)) && SourceOf(result) is null)
            result.AddError("--calculation-port needs --connect, --udp or a source: it is another port of the same server.");
        _play.RejectContradictions(result, _files.IsGiven(result), _connect, _udp, _localAddress, _calculationPort, _demo, _diagnose, _once);
        _files.RejectContradictions(
            result,
            [.. _play.Own, _connect, _udp, _demo, _allowSender, _localAddress, _diagnose, _commandPort, _calculationPort, _once, _frames, _duration, _quiet, .. _commands.Own, .. _export.Own, .. _recording.Own],
            _order,
            _json);
        if (!_files.IsGiven(result))
            _commands.RejectContradictions(result, [_play.File, _connect, _udp, _localAddress, _calculationPort, _diagnose, _order, _once, _frames, _duration, _quiet], _json);
        _export.RejectContradictions(result, [_diagnose, _commands.Main]);
        _recording.RejectContradictions(result, [_diagnose, _commands.Main], _play.File);
        SameFile.Reject(result, _play.File, _export.File, _recording.Record);
        if (IsGiven(result, _overwrite) && !_export.IsGiven(result) && !_files.IsGiven(result) && !IsGiven(result, _recording.Record))
            result.AddError("--overwrite needs --export, --record, --convert or --plot: there is no other file to replace.");
        if (IsGiven(result, _json) && IsGiven(result, _quiet))
            result.AddError("--json and --quiet exclude each other.");
    }

    private void RejectBesideSource(CommandResult result)
    {
        if (result.GetResult(_source) is not { Tokens: [var source, ..] })
            return;

        Option[] others = [_connect, _udp, _demo, _play.File, _commands.Main, .. _files.Tasks];
        if (others.FirstOrDefault(option => IsGiven(result, option)) is { } other)
            result.AddError($"'{source.Value}' and {other.Name} exclude each other: there is one source.");
        else if (result.GetResult(_diagnose) is { Tokens.Count: > 0 })
            result.AddError($"'{source.Value}' and --diagnose HOST exclude each other: there is one server.");
        else if (IsGiven(result, _localAddress) && SourceOf(result)?.LocalAddress is not null)
            result.AddError($"'{source.Value}' and --local-address exclude each other: both say where to receive.");
    }

    private void RejectForDiagnosis(CommandResult result)
    {
        foreach (Option option in (Option[])[_once, _frames])
        {
            if (IsGiven(result, option))
                result.AddError($"--diagnose and {option.Name} exclude each other.");
        }

        foreach (Option option in (Option[])[_connect, _demo])
        {
            if (IsGiven(result, option) && result.GetResult(_diagnose)!.Tokens.Count > 0)
                result.AddError($"--diagnose HOST and {option.Name} exclude each other: there is one server.");
        }
    }

    internal static bool IsGiven(CommandResult result, Option option) => result.GetResult(option) is { Implicit: false };

    // Null without one, and where it is wrong.
    private SourceAddress? SourceOf(CommandResult result) =>
        result.GetResult(_source) is { Tokens: [var text, ..] } && SourceAddress.TryParse(text.Value, out SourceAddress source, out _) ? source : null;

    private MonitorOptions Read(ParseResult result) => new()
    {
        Server = FindServer(result),
        Files = _files.Read(result, _commands.Avatar, _order, _play.Rate, _json),
        Commands = _commands.Read(result, isDemo: result.GetValue(_demo)),
        Recording = _recording.Read(result, result.GetValue(_overwrite)),
        Diagnose = result.GetResult(_diagnose) is { Implicit: false },
        UdpPort = result.GetValue(_udp) ?? result.GetValue(_source)?.UdpPort,
        LocalAddress = result.GetValue(_localAddress) ?? result.GetValue(_source)?.LocalAddress,
        AllowedSenders = result.GetValue(_allowSender) ?? [],
        RotationOrder = result.GetValue(_order),
        Play = _play.Read(result),
        CommandPort = result.GetValue(_commandPort),
        CalculationPort = result.GetValue(_calculationPort),
        Export = _export.Read(result),
        Once = result.GetValue(_once),
        Frames = result.GetValue(_frames),
        Duration = result.GetValue(_duration),
        Output = result.GetValue(_json) ? OutputKind.Json : result.GetValue(_quiet) ? OutputKind.Quiet : OutputKind.Person,
    };

    // A diagnosis without a word about the server looks at this computer.
    private ServerAddress? FindServer(ParseResult result)
    {
        ServerAddress? named = result.GetValue(_connect) ?? result.GetValue(_source)?.Server;
        if (result.GetResult(_diagnose) is not { Implicit: false } || result.GetValue(_demo))
            return named;

        return result.GetValue(_diagnose) ?? named ?? new ServerAddress("127.0.0.1", ProtocolConstants.DefaultPort);
    }
}
