using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Simulate;

/// <summary>The options for a recording as the source.</summary>
internal sealed class SimulatedPlayArguments
{
    private readonly Option<FileInfo?> _play = new("--play")
    {
        HelpName = "FILE",
        Description = "Play a recording (neuron-mocap watch --record), or the raw bytes of a stream, byte for byte as received, at the recorded "
            + "times. Bytes without times are sent at --rate, at the rate of their timecodes, or at 120 frames per second.",
    };

    private readonly Option<double?> _speed = new("--speed")
    {
        HelpName = "N",
        Description = "With --play: speed relative to the recording, 0.01 to 100. Default: 1. To send as fast as clients read, use --rate max.",
        CustomParser = ParseSpeed,
    };

    public Option[] All => [_play, _speed];

    /// <summary>Whether the source is a recording.</summary>
    public bool IsGiven(CommandResult result) => Verb.IsGiven(result, _play);

    /// <summary>Adds an error for every option that contradicts another one.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="ofSources">Options that shape the packets of other sources.</param>
    public void RejectContradictions(CommandResult result, Option[] ofSources)
    {
        if (result.GetResult(_play) is null)
        {
            if (result.GetResult(_speed) is not null)
                result.AddError("--speed needs --play: the speed of other sources is their --rate.");

            return;
        }

        foreach (Option option in ofSources.Where(option => result.GetResult(option) is { Implicit: false }))
            result.AddError($"--play and {option.Name} exclude each other: a recording is sent as it is.");
    }

    /// <summary>Reads the settings of the recording. Null if the source is not a recording.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="rate">Frames per second.</param>
    /// <param name="loop">Whether the recording restarts at its end.</param>
    /// <exception cref="SimulatorException">The file cannot be played.</exception>
    /// <exception cref="UsageException">An option has no meaning for this file.</exception>
    public SimulatedPlaySettings? Read(ParseResult result, double? rate, bool loop)
    {
        if (result.GetValue(_play) is not { } file)
            return null;

        double? speed = result.GetValue(_speed);
        bool isMax = rate is { } hertz && double.IsPositiveInfinity(hertz);
        if (isMax && speed is not null)
            throw new UsageException("--speed and --rate max exclude each other: with --rate max clients set the speed.");

        return SourceFile.Read(_play.Name, file, () => Open(file, rate, speed, isMax, loop));
    }

    private static SimulatedPlaySettings Open(FileInfo file, double? rate, double? speed, bool isMax, bool loop)
    {
        try
        {
            var options = new PlaybackOptions { FrameRate = isMax ? null : rate };
            using RecordedFrameReader reader = RecordedFrameReader.Open(file.FullName, options);
            string pace = isMax ? "as fast as clients read" : string.Create(CultureInfo.InvariantCulture, $"speed {speed ?? 1:0.##}");
            string description = string.Create(
                CultureInfo.InvariantCulture, $"Playing {file.Name}: {reader.Duration.TotalSeconds:0.0} s, {pace}{(loop ? ", in a loop" : "")}");
            return new SimulatedPlaySettings(file.FullName, speed ?? 1, loop, description);
        }
        catch (ArgumentException)
        {
            throw new UsageException($"--rate: {file.Name} has its own times; --speed changes its speed, and --rate max sends it as fast as clients read.");
        }
    }

    private static double? ParseSpeed(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double speed) && speed is >= 0.01 and <= 100)
            return speed;

        result.AddError($"--speed: '{text}' is not a number from 0.01 to 100; --rate max sends as fast as clients read.");
        return null;
    }
}

/// <summary>A recording as the source.</summary>
/// <param name="Path">The file.</param>
/// <param name="Speed">Speed relative to the recording.</param>
/// <param name="Loop">Whether the recording restarts at its end.</param>
/// <param name="Description">The first line that the program writes.</param>
internal sealed record SimulatedPlaySettings(string Path, double Speed, bool Loop, string Description);
