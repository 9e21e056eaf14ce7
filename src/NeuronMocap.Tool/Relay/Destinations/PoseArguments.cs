using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>How poses are sent.</summary>
internal sealed record PoseSettings
{
    /// <summary>Poses of each avatar per second; 0 for every frame.</summary>
    public double Rate { get; init; } = 60;

    /// <summary>The factor of all positions.</summary>
    public float Scale { get; init; } = 1;

    /// <summary>Whether VMC moves the root over the ground, instead of the hips.</summary>
    public bool MoveRoot { get; init; }

    /// <summary>What plain OSC transforms are relative to.</summary>
    public OscSpace Space { get; init; }
}

/// <summary>The options for destinations vmc:// and osc://.</summary>
internal sealed class PoseArguments
{
    private const string Root = "root";
    private const string Local = "local";

    private readonly Option<double?> _rate = new("--pose-rate")
    {
        HelpName = "HZ",
        Description = "Send at most this many poses of each avatar per second, 0.01 to 1000, or 0 for every frame. Default: 60.",
        CustomParser = static result => Parse(result, 0.01, 1000, "0, or a number from 0.01 to 1000"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<double?> _scale = new("--pose-scale")
    {
        HelpName = "FACTOR",
        Description = "Multiply all positions, 0.0001 to 10000. For vmc://, use the height of the model's hips divided by that of the performer's hips: "
            + "a small model then does not float. For osc://, 0.01 turns centimetres into metres. Default: 1.",
        CustomParser = static result => NumberArgument.Parse(result, 0.0001, 10_000, "a number from 0.0001 to 10000"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<string?> _move = Choice(
        "--vmc-move", "With vmc://: move the hips over the ground, or the root, for programs that take no positions of bones. Default: hips.", "hips", Root);

    private readonly Option<string?> _space = Choice(
        "--osc-space", "With osc://: send the transforms of bones in the world, or relative to their parents. Default: world.", "world", Local);

    public Option[] All => [_rate, _scale, _move, _space];

    /// <summary>Adds an error for every option that none of the destinations has a use for.</summary>
    public void Reject(CommandResult result, IReadOnlyList<Destination> destinations)
    {
        bool hasPoses = destinations.Any(static to => to is PoseDestination);
        bool hasVmc = destinations.Any(static to => to is VmcDestination);
        bool hasOsc = destinations.Any(static to => to is OscDestination);
        Reject(result, _rate, hasPoses, "vmc:// or osc://: other destinations get every packet");
        Reject(result, _scale, hasPoses, "vmc:// or osc://: other destinations get packets as they came");
        Reject(result, _move, hasVmc, "vmc://: other destinations have no root");
        Reject(result, _space, hasOsc, "osc://: VMC has transforms relative to the parents");
    }

    /// <summary>Passes the options to the destinations that have a use for them.</summary>
    public Destination[] Apply(ParseResult result, IEnumerable<Destination> destinations)
    {
        var defaults = new PoseSettings();
        var settings = new PoseSettings
        {
            Rate = result.GetValue(_rate) ?? defaults.Rate,
            Scale = (float)(result.GetValue(_scale) ?? defaults.Scale),
            MoveRoot = Root.Equals(result.GetValue(_move), StringComparison.OrdinalIgnoreCase),
            Space = Local.Equals(result.GetValue(_space), StringComparison.OrdinalIgnoreCase) ? OscSpace.Local : OscSpace.World,
        };
        return [.. destinations.Select(to => to is PoseDestination pose ? pose with { Settings = settings } : to)];
    }

    private static double? Parse(ArgumentResult result, double least, double most, string expected) =>
        result.Tokens[0].Value is "0" ? 0 : NumberArgument.Parse(result, least, most, expected);

    // An option with two words as its values.
    private static Option<string?> Choice(string name, string description, params string[] words)
    {
        var option = new Option<string?>(name)
        {
            HelpName = string.Join('|', words),
            Description = description,
            CustomParser = result =>
            {
                string text = result.Tokens[0].Value;
                if (!words.Contains(text, StringComparer.OrdinalIgnoreCase))
                    result.AddError($"{name}: '{text}' is not {string.Join(" or ", words)}.");

                return text;
            },
            Arity = ArgumentArity.ExactlyOne,
        };
        option.CompletionSources.Add(words);
        return option;
    }

    private static void Reject(CommandResult result, Option option, bool isUseful, string needed)
    {
        if (!isUseful && Verb.IsGiven(result, option))
            result.AddError($"{option.Name} needs a destination {needed}.");
    }
}
