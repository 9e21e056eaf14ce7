using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Csv;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Convert;

/// <summary>The options of convert for a table of poses.</summary>
internal sealed class TableArguments
{
    private static readonly Dictionary<string, UpAxis> Axes = new(StringComparer.OrdinalIgnoreCase) { ["y"] = UpAxis.Y, ["z"] = UpAxis.Z };
    private static readonly Dictionary<string, LengthUnit> Units = new(StringComparer.OrdinalIgnoreCase) { ["m"] = LengthUnit.Metres, ["cm"] = LengthUnit.Centimetres };

    private readonly Option<UpAxis?> _upAxis = Choice(
        "--up", Axes, "For .csv: the axis that points up. With z, X points forward and Y to the left, as in ROS. Default: y, with X to the left and Z forward.");

    private readonly Option<LengthUnit?> _unit = Choice("--unit", Units, "For .csv: the unit of positions, metres or centimetres. Default: m.");

    public Option[] Options => [_upAxis, _unit];

    public UpAxis? ReadUpAxis(ParseResult result) => result.GetValue(_upAxis);

    public LengthUnit? ReadUnit(ParseResult result) => result.GetValue(_unit);

    /// <summary>Adds an error if another kind of file is written.</summary>
    public void RejectForOthers(CommandResult result, string? output)
    {
        if (output is null || FileKinds.OfName(output) is null or FileKind.Csv)
            return;

        foreach (Option option in Options)
        {
            if (result.GetResult(option) is not null)
                result.AddError($"{option.Name} is for .csv files.");
        }
    }

    private static Option<T?> Choice<T>(string name, Dictionary<string, T> words, string description)
        where T : struct
    {
        var option = new Option<T?>(name)
        {
            HelpName = string.Join('|', words.Keys),
            Description = description,
            CustomParser = result =>
            {
                string text = result.Tokens[0].Value;
                if (words.TryGetValue(text, out T value))
                    return value;

                result.AddError($"{name}: '{text}' is not one of {string.Join(", ", words.Keys)}.");
                return null;
            },
            Arity = ArgumentArity.ExactlyOne,
        };
        option.CompletionSources.Add([.. words.Keys]);
        return option;
    }
}
