using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Net;

namespace NeuronMocap.Tool.Arguments;

/// <summary>Options that several verbs have, each with the same name, values and errors. Every call creates a new option.</summary>
internal static class CommonOptions
{
    private const double LongestTime = 1_000_000;

    public static Option<bool> Json(string description) => new("--json") { Description = description };

    public static Option<bool> Quiet() => new("--quiet") { Description = "Print only the summary at the end, as one JSON object." };

    public static Option<bool> Overwrite(string files) => new("--overwrite") { Description = $"Overwrite {files}. Without this option, an existing file is an error." };

    public static Option<long?> Frames() => new("--frames")
    {
        HelpName = "N",
        Description = "End after N frames, motion and calculation together; N is 1 or more.",
        CustomParser = static result =>
        {
            string text = result.Tokens[0].Value;
            if (long.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out long frames) && frames > 0)
                return frames;

            result.AddError($"--frames: '{text}' is not a whole number of 1 or more.");
            return null;
        },
        Arity = ArgumentArity.ExactlyOne,
    };

    /// <summary>The time after which to end.</summary>
    public static Option<TimeSpan?> Duration(string description) => new("--duration")
    {
        HelpName = "SECONDS",
        Description = description,
        CustomParser = static result =>
            NumberArgument.Parse(result, double.Epsilon, LongestTime, "a number of seconds, more than 0 and at most 1000000") is { } seconds
                ? TimeSpan.FromSeconds(seconds)
                : null,
        Arity = ArgumentArity.ExactlyOne,
    };

    /// <summary>A time within a take.</summary>
    public static Option<double?> Time(string name, string description) => new(name)
    {
        HelpName = "SECONDS",
        Description = description,
        CustomParser = static result => NumberArgument.Parse(result, 0, LongestTime, "a number of seconds, 0 to 1000000"),
        Arity = ArgumentArity.ExactlyOne,
    };

    public static Option<RotationOrder?> Order(string name, string description)
    {
        string[] orders = Enum.GetNames<RotationOrder>();
        var option = new Option<RotationOrder?>(name)
        {
            HelpName = "ORDER",
            Description = $"{description} One of {string.Join(", ", orders)}.",
            CustomParser = static result => RotationOrderArgument.Parse(result),
            Arity = ArgumentArity.ExactlyOne,
        };
        option.CompletionSources.Add(orders);
        return option;
    }

    /// <summary>The rotation order of a stream in a file.</summary>
    public static Option<RotationOrder?> StreamOrder() => Order(
        "--order", "For a recording or the bytes of a stream: its rotation order, if the file does not state it. Default: YXZ.");

    /// <summary>The frame rate of a file without times.</summary>
    /// <param name="files">The files without times that the verb reads.</param>
    public static Option<double?> Rate(string files = "a file that holds bytes without times or a calculation export") => new("--rate")
    {
        HelpName = "HZ",
        Description = $"Frames per second of each avatar, 0.01 to 100000, for {files}. Default: the rate of its timecodes, or 120.",
        CustomParser = static result => NumberArgument.Parse(result, 0.01, 100_000, "a number from 0.01 to 100000"),
        Arity = ArgumentArity.ExactlyOne,
    };

    /// <summary>The index of an avatar.</summary>
    public static Option<int?> Avatar(string description) => new("--avatar")
    {
        HelpName = "N",
        Description = description,
        CustomParser = static result => NumberArgument.ParseWhole(result, 0, int.MaxValue, "an avatar number, from 0"),
        Arity = ArgumentArity.ExactlyOne,
    };

    /// <summary>The number of a sender in a file.</summary>
    public static Option<int?> Sender() => new("--sender")
    {
        HelpName = "N",
        Description = "For a recording of several UDP senders: number of the sender, from 0. Default: the first.",
        CustomParser = static result => NumberArgument.ParseWhole(result, 0, int.MaxValue, "a sender number, from 0"),
        Arity = ArgumentArity.ExactlyOne,
    };

    public static Option<int?> Port(string name, string description) => new(name)
    {
        HelpName = "PORT",
        Description = description,
        CustomParser = static result => NumberArgument.ParseWhole(result, 1, IPEndPoint.MaxPort, $"a number from 1 to {IPEndPoint.MaxPort}"),
        Arity = ArgumentArity.ExactlyOne,
    };

    public static Option<IPAddress?> Address(string name, string description) => new(name)
    {
        HelpName = "ADDRESS",
        Description = description,
        CustomParser = static result => ParseAddress(result, result.Tokens[0]),
        Arity = ArgumentArity.ExactlyOne,
    };

    /// <summary>Addresses. The option is repeated for each of them.</summary>
    public static Option<IPAddress[]> Addresses(string name, string description) => new(name)
    {
        HelpName = "ADDRESS",
        Description = description,
        CustomParser = static result => [.. result.Tokens.Select(token => ParseAddress(result, token)).OfType<IPAddress>()],
        Arity = ArgumentArity.OneOrMore,
    };

    private static IPAddress? ParseAddress(ArgumentResult result, Token token)
    {
        if (IPAddress.TryParse(token.Value, out IPAddress? address))
            return address;

        result.AddError($"{((OptionResult)result.Parent!).Option.Name}: '{token.Value}' is not an IP address.");
        return null;
    }
}
