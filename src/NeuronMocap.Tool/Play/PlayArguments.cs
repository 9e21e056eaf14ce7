using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Play;

/// <summary>The options of a file as the source.</summary>
internal sealed class PlayArguments
{
    private readonly Option<string?> _play = new("--play")
    {
        HelpName = "FILE",
        Description = "Show a recording (--record), or the bytes of a stream that somebody wrote to a file, as if it arrived now.",
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<double?> _speed = new("--speed")
    {
        HelpName = "N|max",
        Description = "With --play: how many times as fast as it was recorded, 0.01 to 100, or max: as fast as it can be shown, with nothing left out. Default: 1.",
        CustomParser = static result => string.Equals(result.Tokens[0].Value, "max", StringComparison.OrdinalIgnoreCase)
            ? RecordingPlayer.MaxSpeed
            : NumberArgument.Parse(result, 0.01, 100, "a number from 0.01 to 100, or max"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<double?> _rate = new("--rate")
    {
        HelpName = "HZ",
        Description = "With --play, --info, --convert and --plot: frames of each avatar per second of a file that holds bytes without times, or of a calculation export, 0.01 to 100000. Default: as its timecodes say, or 120.",
        CustomParser = static result => NumberArgument.Parse(result, 0.01, 100_000, "a number from 0.01 to 100000"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<bool> _loop = new("--loop")
    {
        Description = "With --play: start again at the end.",
        Arity = ArgumentArity.Zero,
    };

    /// <summary>The option that names the file.</summary>
    public Option File => _play;

    /// <summary>The option that says the rate of a file without times, one to play or another one to read.</summary>
    public Option<double?> Rate => _rate;

    /// <summary>All but <see cref="Rate"/>.</summary>
    public Option[] Own => [_play, _speed, _loop];

    public void AddTo(RootCommand root)
    {
        foreach (Option option in (Option[])[_play, _speed, _rate, _loop])
            root.Options.Add(option);
    }

    /// <summary>Adds an error for every option that has no meaning beside another.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="readsFile">Whether a tool for files runs.</param>
    /// <param name="ofConnection">Options that are about a connection.</param>
    public void RejectContradictions(CommandResult result, bool readsFile, params Option[] ofConnection)
    {
        if (!CommandLine.IsGiven(result, _play))
        {
            foreach (Option option in ((Option[])[_speed, _loop]).Where(option => CommandLine.IsGiven(result, option)))
                result.AddError($"{option.Name} needs --play: a live stream comes as it comes.");

            if (CommandLine.IsGiven(result, _rate) && !readsFile)
                result.AddError("--rate needs --play, --info, --convert or --plot: a live stream comes as it comes.");

            return;
        }

        foreach (Option option in ofConnection.Where(option => CommandLine.IsGiven(result, option)))
            result.AddError($"--play and {option.Name} exclude each other: nothing is connected to.");
    }

    public PlaySettings? Read(ParseResult result) => result.GetValue(_play) is { } file
        ? new PlaySettings(file, result.GetValue(_speed) ?? 1, result.GetValue(_rate), result.GetValue(_loop))
        : null;
}
