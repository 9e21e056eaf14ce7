using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Files;

/// <summary>The options of the tools for files.</summary>
/// <param name="overwrite">The option that lets a file be replaced; other options have it, too.</param>
internal sealed class FileArguments(Option<bool> overwrite)
{
    private const double LongestTime = 1_000_000;
    private const double LowestRate = 0.01;
    private const double HighestRate = 10_000;
    private const int TwoFiles = 2;

    private readonly Option<string?> _info = new("--info")
    {
        HelpName = "FILE",
        Description = "Say what a file holds and what is odd about it: a BVH file, a recording, a calculation export or the raw bytes of a stream. "
            + "With --json as one object.",
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<string[]> _convert = new("--convert")
    {
        HelpName = "IN OUT",
        Description = "Write a file as another kind of file, or a part of it. The name of OUT says which kind: .bvh, .nmrec (recording), .calc "
            + "(calculation export), .bin or .dat (the bytes of the stream).",
        Arity = new ArgumentArity(TwoFiles, TwoFiles),
        AllowMultipleArgumentsPerToken = true,
    };

    private readonly Option<string[]> _plot = new("--plot")
    {
        HelpName = "FILE OUT.svg",
        Description = "Draw a file: skeletons at regular times, the way over the ground, heights of the feet and speeds.",
        Arity = new ArgumentArity(TwoFiles, TwoFiles),
        AllowMultipleArgumentsPerToken = true,
    };

    private readonly Option<double?> _rate = new("--resample")
    {
        HelpName = "HZ",
        Description = $"With --convert: make this many frames per second, {LowestRate} to {HighestRate}; what lies between two frames is interpolated. Default: as many as IN has.",
        CustomParser = static result => NumberArgument.Parse(result, LowestRate, HighestRate, "a number from 0.01 to 10000"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<RotationOrder?> _inputOrder = new("--input-order")
    {
        HelpName = string.Join('|', Enum.GetNames<RotationOrder>()),
        Description = "With --convert of a recording or the bytes of a stream: the order that its rotation values have, where the file does not say it. Default: YXZ.",
        CustomParser = static result => RotationOrderArgument.Parse(result),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<double?> _from = new("--from")
    {
        HelpName = "SECONDS",
        Description = "With --convert and --plot: begin at this time of the take.",
        CustomParser = static result => NumberArgument.Parse(result, 0, LongestTime, "a number of seconds, 0 to 1000000"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<double?> _to = new("--to")
    {
        HelpName = "SECONDS",
        Description = "With --convert and --plot: end at this time of the take.",
        CustomParser = static result => NumberArgument.Parse(result, 0, LongestTime, "a number of seconds, 0 to 1000000"),
        Arity = ArgumentArity.ExactlyOne,
    };

    /// <summary>The options that name a tool.</summary>
    public Option[] Tasks => [_info, _convert, _plot];

    public void AddTo(RootCommand root)
    {
        foreach (Option option in (Option[])[.. Tasks, _rate, _inputOrder, _from, _to])
            root.Options.Add(option);
    }

    /// <summary>Whether one of the tools is asked for.</summary>
    public bool IsGiven(CommandResult result) => Tasks.Any(option => CommandLine.IsGiven(result, option));

    /// <summary>Adds an error for every option that has no meaning beside another.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="ofServer">Options that are about a server or its stream.</param>
    /// <param name="order">The option that names a rotation order.</param>
    /// <param name="json">The option that asks for JSON.</param>
    public void RejectContradictions(CommandResult result, Option[] ofServer, Option order, Option json)
    {
        Option[] tasks = [.. Tasks.Where(option => CommandLine.IsGiven(result, option))];
        if (tasks.Length == 0)
        {
            foreach (Option option in ((Option[])[_rate, _inputOrder, _from, _to]).Where(option => CommandLine.IsGiven(result, option)))
                result.AddError($"{option.Name} needs {(option == _rate || option == _inputOrder ? "--convert" : "--convert or --plot")}: it is about the file that is written.");

            return;
        }

        Option task = tasks[0];
        if (tasks.Length > 1)
            result.AddError($"{task.Name} and {tasks[1].Name} exclude each other.");

        Option[] foreign = task == _info ? [overwrite, _rate, _inputOrder, _from, _to] : task == _plot ? [_rate, _inputOrder, json] : [json];
        foreach (Option option in ((Option[])[.. ofServer, .. foreign]).Where(option => CommandLine.IsGiven(result, option)))
            result.AddError($"{task.Name} and {option.Name} exclude each other.");

        if (task == _convert && OutputOf(result, _convert) is { } converted && FileKinds.OfName(converted) is null)
        {
            result.AddError(
                $"--convert: the name '{converted}' does not say what to write. Known are .bvh, .nmrec (recording), .calc (calculation export), "
                + ".bin and .dat (the bytes of the stream).");
        }

        if (task == _plot && OutputOf(result, _plot) is { } drawn && !drawn.EndsWith(".svg", StringComparison.OrdinalIgnoreCase))
            result.AddError($"--plot: the name '{drawn}' does not end with .svg, the only kind of picture.");

        // The parser counts the words of one option, but not those of an option that is given twice.
        if (result.GetResult(task)?.Tokens is { Count: > TwoFiles })
            result.AddError($"{task.Name} takes two files, and more are given.");
    }

    public FileSettings? Read(ParseResult result, Option<int?> avatar, Option<RotationOrder?> order, Option<double?> inputRate, Option<bool> json)
    {
        if (Tasks.FirstOrDefault(option => result.GetResult(option) is { Implicit: false }) is not { } task)
            return null;

        string[] files = task == _info ? [result.GetValue(_info)!] : result.GetValue(task == _plot ? _plot : _convert)!;
        FileTask what = task == _info ? FileTask.Info : task == _plot ? FileTask.Plot : FileTask.Convert;
        return new FileSettings(what, files[0], files.ElementAtOrDefault(1))
        {
            Overwrite = result.GetValue(overwrite),
            Avatar = result.GetValue(avatar),
            RotationOrder = result.GetValue(order),
            InputOrder = result.GetValue(_inputOrder),
            Rate = result.GetValue(_rate),
            InputRate = result.GetValue(inputRate),
            From = result.GetValue(_from),
            To = result.GetValue(_to),
            Json = result.GetValue(json),
        };
    }

    // Null when it is missing, which the parser tells.
    private static string? OutputOf(CommandResult result, Option option) =>
        result.GetResult(option) is { Tokens: [_, var output] } ? output.Value : null;
}
