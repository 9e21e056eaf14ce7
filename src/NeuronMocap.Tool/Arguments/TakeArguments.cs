using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Arguments;

/// <summary>The arguments of verbs that create a file from another file.</summary>
internal sealed class TakeArguments
{
    private readonly Argument<string> _input = new("IN")
    {
        Description = "A BVH file, a recording, a calculation export, or the raw bytes of a stream; its name does not matter.",
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Argument<string> _output;
    private readonly Option<double?> _from = CommonOptions.Time("--from", "Start at this time of the take.");
    private readonly Option<double?> _to = CommonOptions.Time("--to", "End at this time of the take.");
    private readonly Option<bool> _overwrite = CommonOptions.Overwrite("the file");
    private readonly Option<double?> _rate = CommonOptions.Rate();
    private readonly Option<RotationOrder?> _order = CommonOptions.StreamOrder();
    private readonly Option<int?> _avatar = CommonOptions.Avatar("For a recording: number of the avatar, from 0. Default: the first.");
    private readonly Option<int?> _sender = CommonOptions.Sender();

    /// <summary>Creates the arguments.</summary>
    /// <param name="outputName">Name of the output file in the help.</param>
    /// <param name="outputDescription">Description of the output file.</param>
    public TakeArguments(string outputName, string outputDescription) =>
        _output = new Argument<string>(outputName) { Description = outputDescription, Arity = ArgumentArity.ExactlyOne };

    /// <summary>The meaning of the exit codes.</summary>
    public static IReadOnlyList<(int Code, string Meaning)> Codes { get; } =
    [
        (ToolCommand.Done, "done"),
        (ToolCommand.NothingReceived, "not read or written; standard error says why"),
        (ToolCommand.Interrupted, "ended by Ctrl+C or SIGTERM, nothing written"),
    ];

    public Argument[] Files => [_input, _output];

    public Option[] Options => [_from, _to, _avatar, _sender, _rate, _order, _overwrite];

    /// <summary>Gets the file to write. Null if it is missing, which the parser reports.</summary>
    public string? FindOutput(CommandResult result) => result.GetResult(_output) is { Tokens: [var output] } ? output.Value : null;

    /// <summary>Adds an error if the end is not later than the start.</summary>
    public void RejectContradictions(CommandResult result)
    {
        if (TimeOf(result, _from) >= TimeOf(result, _to))
            result.AddError("--to must be later than --from.");
    }

    public FileSettings Read(ParseResult result) => new(result.GetValue(_input)!, result.GetValue(_output))
    {
        From = result.GetValue(_from),
        To = result.GetValue(_to),
        Avatar = result.GetValue(_avatar),
        Sender = result.GetValue(_sender),
        InputRate = result.GetValue(_rate),
        InputOrder = result.GetValue(_order),
        Overwrite = result.GetValue(_overwrite),
    };

    // Null if the value is wrong, which the parser reports.
    private static double? TimeOf(CommandResult result, Option<double?> option) =>
        result.GetResult(option) is { Tokens: [var time] } && double.TryParse(time.Value, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double seconds)
            ? seconds
            : null;
}
