using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Runtime.InteropServices;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Fuzz.Running;

namespace NeuronMocap.Fuzz;

/// <summary>The command line. The exit code is 0 for no findings, 1 for findings, 2 for bad usage, and 128 plus the signal when stopped.</summary>
internal sealed class FuzzCommand : RootCommand
{
    private const int Clean = 0;
    private const int Failed = 1;
    private const int BadUsage = 2;
    private const int Interrupted = 130;
    private const int Terminated = 143;

    private readonly Option<long> _bytes = new("--bytes")
    {
        HelpName = "N",
        Description = "Total bytes of all inputs.",
        DefaultValueFactory = _ => 50_000_000,
    };

    private readonly Option<ulong> _seed = new("--seed")
    {
        HelpName = "S",
        Description = "Seed of the inputs: a number, or today for the date (UTC).",
        DefaultValueFactory = _ => 1,
        CustomParser = ParseSeed,
    };

    private readonly Option<int> _seeds = new("--seeds")
    {
        HelpName = "N",
        Description = "Number of seeds to run, one after the other from --seed on, with --bytes for each.",
        DefaultValueFactory = _ => 1,
    };

    private readonly Option<string[]> _target = new("--target")
    {
        HelpName = "NAME",
        Description = "Run only this target; may be repeated. It gets the same inputs as in a full run.",
    };

    private readonly Option<bool> _list = new("--list") { Description = "List the targets and exit." };

    private readonly Option<DirectoryInfo> _data = new("--data")
    {
        HelpName = "DIR",
        Description = "Folder of recorded streams (*.bin) and takes (*.bvh) to create inputs from. Default: shared/data beside the repository, if it exists.",
    };

    private readonly Option<string> _output = new("--output")
    {
        HelpName = "DIR",
        Description = "Folder for failing inputs.",
        DefaultValueFactory = _ => "fuzz-failures",
    };

    private readonly Option<FileInfo> _replay = new("--replay") { HelpName = "FILE", Description = "Run only this input, with each target." };

    private readonly IReadOnlyList<FuzzTarget> _targets;

    public FuzzCommand(IReadOnlyList<FuzzTarget> targets)
        : base("Feeds modified packets and files to the parsers, which must not throw, hang, allocate beyond their limits or read out of bounds.")
    {
        _targets = targets;
        _bytes.Validators.Add(result =>
        {
            if (result.GetValue(_bytes) < 1)
                result.AddError("--bytes: must be 1 or more.");
        });
        _seeds.Validators.Add(result =>
        {
            if (result.GetValue(_seeds) < 1)
                result.AddError("--seeds: must be 1 or more.");
        });
        _target.AcceptOnlyFromAmong([.. targets.Select(target => target.Name)]);
        _data.AcceptExistingOnly();
        _replay.AcceptExistingOnly();
        foreach (Option option in (Option[])[_bytes, _seed, _seeds, _target, _list, _data, _output, _replay])
            Options.Add(option);

        SetAction(Run);
    }

    public int Invoke(string[] args)
    {
        ParseResult result = Parse(args);
        if (result.Errors.Count == 0)
            return result.Invoke(new InvocationConfiguration { ProcessTerminationTimeout = null });

        foreach (string message in result.Errors.Select(error => error.Message))
            Console.Error.WriteLine(message);

        return BadUsage;
    }

    private int Run(ParseResult options)
    {
        string[] names = options.GetValue(_target) ?? [];
        FuzzTarget[] targets = [.. _targets.Where(target => names.Length == 0 || names.Contains(target.Name))];
        if (options.GetValue(_list))
        {
            foreach (FuzzTarget target in targets)
                Console.WriteLine($"{target.Name,-12}{target.Corpus}");

            return Clean;
        }

        return options.GetValue(_replay) is { } file
            ? Replay(targets, File.ReadAllBytes(file.FullName))
            : Fuzz(targets, options);
    }

    private int Fuzz(FuzzTarget[] targets, ParseResult options)
    {
        ulong first = options.GetValue(_seed);
        int seeds = options.GetValue(_seeds);
        using var stop = new CancellationTokenSource();
        int signal = 0;
        using PosixSignalRegistration interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, context => Stop(context, Interrupted));
        using PosixSignalRegistration terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, context => Stop(context, Terminated));

        int failedSeeds = 0;
        int done = 0;
        for (bool isCutShort = false; done < seeds && !isCutShort && signal == 0; done++)
        {
            failedSeeds += Fuzz(targets, options, first + (ulong)done, stop.Token, out isCutShort) ? 0 : 1;
        }

        if (seeds > 1)
            Console.WriteLine($"{done} of {seeds} seeds run; {failedSeeds} of them failed");

        return signal != 0 ? signal : failedSeeds == 0 ? Clean : Failed;

        void Stop(PosixSignalContext context, int code)
        {
            context.Cancel = true;
            signal = code;
            stop.Cancel();
        }
    }

    // Returns true if nothing was found.
    private bool Fuzz(FuzzTarget[] targets, ParseResult options, ulong seed, CancellationToken cancellationToken, out bool isCutShort)
    {
        long bytes = options.GetValue(_bytes);
        string? data = DataFolder(options);
        var run = new FuzzRun(targets, bytes, seed, data, cancellationToken);
        Console.WriteLine(FuzzReport.DescribeCorpora(run, seed, data));
        var report = new FuzzReport(run, bytes);
        run.Run(report.Tick);
        report.Summarize();
        isCutShort = run.IsCutShort;
        FailingInput[] all = [.. run.Progress.SelectMany(target => target.FailingInputs)];
        foreach (FailingInput failing in all)
        {
            string path = FailingInputFiles.Write(failing, seed, options.GetValue(_output)!);
            Console.Error.WriteLine($"{failing.Target}: {failing.Failure.Kind}, {failing.Smallest.Length} bytes in {path}");
            Console.Error.WriteLine(failing.Failure.Description);
        }

        return all.Length == 0;
    }

    // The seed 20261122 is that of the day on every computer, and repeats the same run.
    private static ulong ParseSeed(ArgumentResult result)
    {
        string text = result.Tokens.Count == 1 ? result.Tokens[0].Value : string.Empty;
        if (string.Equals(text, "today", StringComparison.Ordinal))
            text = DateTime.UtcNow.ToString("yyyyMMdd", CultureInfo.InvariantCulture);
        if (ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed))
            return seed;

        result.AddError("--seed: a whole number from 0 on, or today.");
        return 0;
    }

    private static int Replay(FuzzTarget[] targets, byte[] input)
    {
        if (input.Length > FuzzInput.MaxLength)
        {
            Console.Error.WriteLine($"--replay: an input has at most {FuzzInput.MaxLength} bytes.");
            return BadUsage;
        }

        int failures = 0;
        foreach (FuzzTarget target in targets)
        {
            FuzzFailure? failure = new InputRunner(target).Run(input, isThorough: true);
            failures += failure is null ? 0 : 1;
            Console.WriteLine($"{target.Name,-12}{(failure is null ? "nothing wrong" : $"{failure.Kind}: {failure.Description}")}");
        }

        return failures == 0 ? Clean : Failed;
    }

    private string? DataFolder(ParseResult options)
    {
        if (options.GetValue(_data) is { } given)
            return given.FullName;

        DirectoryInfo? folder = new(AppContext.BaseDirectory);
        while (folder is not null && !Directory.Exists(Path.Combine(folder.FullName, "shared", "data")))
            folder = folder.Parent;

        return folder is null ? null : Path.Combine(folder.FullName, "shared", "data");
    }
}
