using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Watch.Playback;

/// <summary>The options of a playback.</summary>
internal sealed class PlaybackArguments
{
    public Option<double?> Speed { get; } = new("--speed")
    {
        HelpName = "N|max",
        Description = "Speed relative to the recording, 0.01 to 100, or max: as fast as possible, with no frame left out. Default: 1.",
        CustomParser = static result => string.Equals(result.Tokens[0].Value, "max", StringComparison.OrdinalIgnoreCase)
            ? RecordingPlayer.MaxSpeed
            : NumberArgument.Parse(result, 0.01, 100, "a number from 0.01 to 100, or max"),
        Arity = ArgumentArity.ExactlyOne,
    };

    public Option<double?> Rate { get; } = CommonOptions.Rate("a file that holds bytes without times");

    public Option<bool> Loop { get; } = new("--loop") { Description = "Start again at the end." };

    public Option[] All => [Speed, Rate, Loop];

    /// <summary>Adds an error for every given option, because the source is not a file.</summary>
    public void Reject(CommandResult result)
    {
        foreach (Option option in All.Where(option => Verb.IsGiven(result, option)))
            result.AddError($"{option.Name} needs a file as the source: a live stream cannot be controlled.");
    }

    public PlaySettings Read(ParseResult result, string file) =>
        new(file, result.GetValue(Speed) ?? 1, result.GetValue(Rate), result.GetValue(Loop));
}
