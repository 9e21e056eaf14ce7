using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Net;
using System.Numerics;
using NeuronMocap.Protocol;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Simulate;

/// <summary>An option with the values on and off. It is not a bool, because the parser would take it for an option without a value.</summary>
internal enum OnOff
{
    On,
    Off,
}

/// <summary>The options of simulate: names, ranges and help. Other programs depend on them.</summary>
internal sealed class SimulateArguments
{
    private static readonly string[] OnOffWords = ["on", "off"];

    public SimulateArguments()
    {
        Rate.CustomParser = ParseRate;
        Order.CustomParser = ParseWord<RotationOrder>(Enum.GetNames<RotationOrder>());
        Bind.CustomParser = ParseAddress;
        Port.CustomParser = ParseNumber(0, 65_535);
        Avatars.CustomParser = ParseNumber(1, 256);
        Frames.CustomParser = ParseNumber(1L, long.MaxValue);
        Fragment.CustomParser = ParseNumber(1, 1_048_576);
        Displacement.CustomParser = ParseWord<OnOff>(OnOffWords);
        Reference.CustomParser = ParseWord<OnOff>(OnOffWords);
        Format.CustomParser = ParseWord<BroadcastFormat>("binary", "text", "studio");
        Header.CustomParser = ParseWord<HeaderLayout>("new", "old");
        Decimals.CustomParser = ParseNumber(0, TextEncoder.MaxDecimals);
        Motion.CustomParser = ParseWord<OnOff>(OnOffWords);
        CalculationPort.CustomParser = ParsePort(ProtocolConstants.DefaultCalculationPort);
        CommandPort.CustomParser = ParsePort(ProtocolConstants.DefaultCommandPort);
        DataCommands.CustomParser = ParseWord<OnOff>(OnOffWords);
        Bind.Aliases.Add("--local-address");
        CommandPort.Aliases.Add("--commands");
        foreach ((Option option, string[] words) in (IEnumerable<(Option, string[])>)
            [
                (Order, Enum.GetNames<RotationOrder>()), (Displacement, OnOffWords), (Reference, OnOffWords), (Motion, OnOffWords), (DataCommands, OnOffWords),
                (Format, ["binary", "text", "studio"]), (Header, ["new", "old"]), (Rate, ["max"]),
            ])
        {
            // Removes the names of the enumeration's members.
            option.CompletionSources.Clear();
            option.CompletionSources.Add(words);
        }
    }

    /// <summary>All options, grouped under titles.</summary>
    public IReadOnlyList<(string Title, Option[] Options)> Sections =>
    [
        ("What is sent", [Synthetic, Bvh, Calc, .. Play.All, Avatars, Rate, Frames, Loop]),
        ("Where it is sent", [Port, Bind, Udp, CalculationPort, WaitForClient, CommandPort, DataCommands, Fragment]),
        ("How it is sent", [Format, Header, Order, Displacement, Reference, Calculation, Motion, Decimals]),
    ];

    public Option<FileInfo?> Bvh { get; } = new("--bvh")
    {
        HelpName = "FILE",
        Description = "Play a BVH file of the Perception Neuron skeleton.",
    };

    public Option<FileInfo?> Calc { get; } = new("--calc")
    {
        HelpName = "FILE",
        Description = "Play a calculation export of Axis Neuron; with --calculation, its own values are sent with the poses.",
    };

    public Option<bool> Synthetic { get; } = new("--synthetic")
    {
        Description = "Play a synthetic actor, without end. This is the default.",
    };

    public Option<IPAddress> Bind { get; } = new("--bind")
    {
        HelpName = "ADDRESS",
        Description = "Address of this computer to listen on; 0.0.0.0 for all. Default: 127.0.0.1.",
    };

    public Option<int?> Port { get; } = new("--port")
    {
        HelpName = "PORT",
        Description = "TCP port to listen on, 0 to 65535; 0 takes any free port. Default: 7001, or none with --udp.",
    };

    public Option<ServerAddress[]> Udp { get; } = new("--udp")
    {
        HelpName = "HOST:PORT",
        Description = "Send UDP datagrams to this address; may be repeated. Listens on TCP as well only if --port is given.",
        CustomParser = static result => ParseDestinations(result),
    };

    public Option<int?> Avatars { get; } = new("--avatars") { HelpName = "N", Description = "Number of avatars, 1 to 256. Default: 1." };

    public Option<double?> Rate { get; } = new("--rate")
    {
        HelpName = "HZ|max",
        Description = "Frames per second, 0.01 to 100000, or max: each client gets all frames from frame 0, as fast as it reads; "
            + "the program ends when clients have connected and all have left. A file is sent row by row, so a rate other than its own changes its speed. "
            + "Default: the rate of the source.",
    };

    public Option<long?> Frames { get; } = new("--frames")
    {
        HelpName = "N",
        Description = "Frames of each avatar to send, at least 1. Default: all.",
    };

    public Option<bool> Loop { get; } = new("--loop") { Description = "Repeat the file." };

    public Option<bool> WaitForClient { get; } = new("--wait-for-client")
    {
        Description = "Wait for the first TCP client, which then gets frame 0. With --calculation-port, wait for a client of each port.",
    };

    public Option<OnOff?> Displacement { get; } = new("--displacement")
    {
        HelpName = "on|off",
        Description = "Send positions of all bones (cm), not only of the hips. Default: on, or as in the BVH file.",
    };

    public Option<OnOff?> Reference { get; } = new("--reference")
    {
        HelpName = "on|off",
        Description = "Send the six values of the reference first. Default: off.",
    };

    public Option<RotationOrder?> Order { get; } = new("--order")
    {
        HelpName = "ORDER",
        Description = "Rotation order: XYZ, XZY, YXZ, YZX, ZXY or ZYX. Default: YXZ, or that of the BVH file.",
    };

    public Option<BroadcastFormat?> Format { get; } = new("--format")
    {
        HelpName = "binary|text|studio",
        Description = "Packets of Axis Neuron, lines of text (its block type String), or packets of Axis Studio, version 1.1.0.1, "
            + "with rotation order, timecode and its own calculation packets. Programs with the vendor's b12 library crash on the packets of Axis Studio because of a bug in that library. "
            + "Default: binary.",
    };

    public Option<HeaderLayout?> Header { get; } = new("--header")
    {
        HelpName = "new|old",
        Description = "Header layout: new is version 1.1.0.0; old is 1.0.0.2, which is also Axis Studio's old header. Format binary only. Default: new.",
    };

    public Option<int?> Decimals { get; } = new("--decimals")
    {
        HelpName = "N",
        Description = "Decimals of the numbers, 0 to 6. Format text only. Default: 2.",
    };

    public Option<bool> Calculation { get; } = new("--calculation")
    {
        Description = "Send a calculation packet, or line, after each motion packet.",
    };

    public Option<int?> CalculationPort { get; } = new("--calculation-port")
    {
        HelpName = "PORT",
        Description = "Send calculation packets, or lines, on this port, 0 to 65535, and only motion on the other. TCP clients connect to both; UDP receivers get "
            + $"both from two sockets. Default without PORT: {ProtocolConstants.DefaultCalculationPort}.",
        Arity = ArgumentArity.ZeroOrOne,
    };

    public Option<OnOff?> Motion { get; } = new("--motion")
    {
        HelpName = "on|off",
        Description = "off: send only calculation packets, or lines, to --port and --udp. Default: on.",
    };

    public Option<int?> Fragment { get; } = new("--fragment")
    {
        HelpName = "BYTES",
        Description = "Size in bytes, 1 to 1048576. TCP is written in pieces of exactly this size, UDP in datagrams of at most this size. Default: whole packets.",
    };

    public Option<OnOff?> DataCommands { get; } = new("--data-commands")
    {
        HelpName = "on|off",
        Description = "Answer commands of the b11 and b12 libraries on the data connection; newer servers do not. Default: on.",
    };

    public Option<int?> CommandPort { get; } = new("--command-port")
    {
        HelpName = "PORT",
        Description = "Also open a command channel on this TCP port, 0 to 65535: rotation order, bone sizes, BVH headers and zero-out. "
            + $"Default without PORT: {ProtocolConstants.DefaultCommandPort}.",
        Arity = ArgumentArity.ZeroOrOne,
    };

    public SimulatedPlayArguments Play { get; } = new();

    private static Func<ArgumentResult, int?> ParsePort(int whenLeftOut) =>
        result => result.Tokens.Count == 0 ? whenLeftOut : ParseNumber(0, 65_535)(result);

    private static Func<ArgumentResult, T?> ParseNumber<T>(T from, T to)
        where T : struct, INumber<T> => result =>
    {
        string text = result.Tokens[0].Value;
        if (T.TryParse(text, NumberStyles.Integer, CultureInfo.InvariantCulture, out T number) && number >= from && number <= to)
            return number;

        result.AddError($"{NameOf(result)}: '{text}' is not a whole number from {from} to {to}.");
        return null;
    };

    // The words are the names of the enumeration, in any case.
    private static Func<ArgumentResult, T?> ParseWord<T>(params string[] words)
        where T : struct, Enum => result =>
    {
        string text = result.Tokens[0].Value;
        if (words.Contains(text, StringComparer.OrdinalIgnoreCase))
            return Enum.Parse<T>(text, ignoreCase: true);

        result.AddError($"{NameOf(result)}: '{text}' is not one of {string.Join(", ", words)}.");
        return null;
    };

    // The name that the user typed.
    private static string? NameOf(ArgumentResult result) => (result.Parent as OptionResult)?.IdentifierToken?.Value;

    private static double? ParseRate(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (string.Equals(text, "max", StringComparison.OrdinalIgnoreCase))
            return BroadcasterOptions.MaxFrameRate;
        if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double rate) && rate is >= 0.01 and <= 100_000)
            return rate;

        result.AddError($"--rate: '{text}' is not a number from 0.01 to 100000, or max.");
        return null;
    }

    private static IPAddress? ParseAddress(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (IPAddress.TryParse(text, out IPAddress? address))
            return address;

        result.AddError($"{NameOf(result)}: '{text}' is not an IP address.");
        return null;
    }

    private static ServerAddress[] ParseDestinations(ArgumentResult result)
    {
        try
        {
            return [.. result.Tokens.Select(static token => ServerAddress.ParseDestination(token.Value))];
        }
        catch (FormatException fault)
        {
            result.AddError($"--udp: {fault.Message}");
            return [];
        }
    }

    /// <summary>Adds an error for every option that contradicts another one.</summary>
    public void RejectContradictions(CommandResult result)
    {
        if (result.GetResult(Bvh) is not null && result.GetResult(Synthetic) is not null)
            result.AddError("--bvh and --synthetic exclude each other.");
        if (result.GetResult(Calc) is not null && (result.GetResult(Bvh) ?? result.GetResult(Synthetic)) is not null)
            result.AddError("--calc, --bvh and --synthetic exclude each other.");
        Play.RejectContradictions(
            result,
            [
                Bvh, Calc, Synthetic, Avatars, Frames, Displacement, Reference, Order, Format, Header, Decimals, Calculation, Motion, DataCommands, CommandPort,
            ]);
        if (result.GetResult(Motion)?.Tokens is [{ Value: var motion }] && motion.Equals(nameof(OnOff.Off), StringComparison.OrdinalIgnoreCase))
            RejectForMotion(result);

        if (Verb.IsGiven(result, Loop) && !Play.IsGiven(result) && !Verb.IsGiven(result, Bvh) && !Verb.IsGiven(result, Calc))
            result.AddError("--loop needs --bvh, --calc or --play: the synthetic actor has no end.");
        if (Verb.IsGiven(result, DataCommands) && Verb.IsGiven(result, Udp) && !Verb.IsGiven(result, Port))
            result.AddError("--data-commands needs a TCP port: give --port as well as --udp.");
        if (result.GetResult(WaitForClient) is not null && result.GetResult(Udp) is not null && result.GetResult(Port) is null)
            result.AddError("--wait-for-client waits for a TCP client: give --port as well as --udp.");
    }

    private void RejectForMotion(CommandResult result)
    {
        if (Verb.IsGiven(result, CalculationPort))
            result.AddError("--motion off sends only calculation data to --port and --udp: leave out --calculation-port.");
        foreach (Option option in ((Option[])[Displacement, Reference]).Where(option => Verb.IsGiven(result, option)))
            result.AddError($"--motion off and {option.Name} exclude each other: only motion packets hold these values.");
    }
}
