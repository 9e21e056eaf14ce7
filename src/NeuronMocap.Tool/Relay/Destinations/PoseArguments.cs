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

    /// <summary>What plain OSC transforms are relative to.</summary>
    public OscSpace Space { get; init; }
}

/// <summary>The options for destinations vmc:// and osc://.</summary>
internal sealed class PoseArguments
{
    private const string World = "world";
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
        Description = "Multiply all positions, 0.0001 to 10000: for vmc://, with the height of the model's hips divided by that of the performer's hips, so that "
            + "a small model does not float; for osc://, 0.01 turns centimetres into metres. Default: 1.",
        CustomParser = static result => NumberArgument.Parse(result, 0.0001, 10_000, "a number from 0.0001 to 10000"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<OscSpace?> _space = new("--osc-space")
    {
        HelpName = $"{World}|{Local}",
        Description = "With osc://: send the transforms of bones in the world, or relative to their parents. Default: world.",
        CustomParser = static result =>
        {
            string text = result.Tokens[0].Value;
            if (text.Equals(World, StringComparison.OrdinalIgnoreCase))
                return OscSpace.World;
            if (text.Equals(Local, StringComparison.OrdinalIgnoreCase))
                return OscSpace.Local;

            result.AddError($"--osc-space: '{text}' is not {World} or {Local}.");
            return null;
        },
        Arity = ArgumentArity.ExactlyOne,
    };

    public PoseArguments() => _space.CompletionSources.Add(World, Local);

    public Option[] All => [_rate, _scale, _space];

    /// <summary>Adds an error for every option that none of the destinations has a use for.</summary>
    public void Reject(CommandResult result, IReadOnlyList<Destination> destinations)
    {
        bool hasPoses = destinations.Any(static to => to is PoseDestination);
        bool hasOsc = destinations.Any(static to => to is OscDestination);
        Reject(result, _rate, hasPoses, "vmc:// or osc://: other destinations get every packet");
        Reject(result, _scale, hasPoses, "vmc:// or osc://: other destinations get packets as they came");
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
            Space = result.GetValue(_space) ?? defaults.Space,
        };
        return [.. destinations.Select(to => to is PoseDestination pose ? pose with { Settings = settings } : to)];
    }

    private static double? Parse(ArgumentResult result, double least, double most, string expected) =>
        result.Tokens[0].Value is "0" ? 0 : NumberArgument.Parse(result, least, most, expected);

    private static void Reject(CommandResult result, Option option, bool isUseful, string needed)
    {
        if (!isUseful && Verb.IsGiven(result, option))
            result.AddError($"{option.Name} needs a destination {needed}.");
    }
}
