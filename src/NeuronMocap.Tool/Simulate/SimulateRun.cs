using System.CommandLine;
using NeuronMocap.Server;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Simulate;

/// <summary>One broadcast, from the options to its end.</summary>
/// <param name="arguments">The options.</param>
/// <param name="result">A command line without errors.</param>
/// <param name="streams">The streams to write to.</param>
internal sealed class SimulateRun(SimulateArguments arguments, ParseResult result, StandardStreams streams)
{
    /// <summary>Broadcasts until everything is sent, or until the user stops it.</summary>
    /// <exception cref="UsageException">An option has no meaning here.</exception>
    /// <exception cref="SimulatorException">A file, host or port that the options name is not available.</exception>
    /// <exception cref="OperationCanceledException">The user stopped the run before the broadcast started.</exception>
    public async Task RunAsync(CancellationToken cancellationToken)
    {
        // A large file is read as a whole, which takes time.
        (BroadcasterOptions options, string description) = await Task.Run(CreateOptions, CancellationToken.None).WaitAsync(cancellationToken);
        using Broadcaster broadcaster = OpenBroadcaster(options);
        using CommandServer? commands = OpenCommands(broadcaster, options);
        Start(broadcaster, options);
        await using CancellationTokenRegistration stop = cancellationToken.Register(broadcaster.Stop);
        await new SimulatorReport(broadcaster, commands, options, description, streams).RunAsync();
    }

    private static Broadcaster OpenBroadcaster(BroadcasterOptions options)
    {
        try
        {
            return new Broadcaster(options);
        }
        catch (ArgumentException exception) when (exception.ParamName is nameof(BroadcasterOptions.FrameRate))
        {
            throw new SimulatorException("--rate: the file's own rate is not from 0.01 to 100000 Hz; set a rate.");
        }
        catch (Exception exception) when (exception is NeuronException or IOException or UnauthorizedAccessException)
        {
            // The file existed a moment ago.
            throw new SimulatorException($"--play: {exception.Message}");
        }
    }

    private static void Start(Broadcaster broadcaster, BroadcasterOptions options)
    {
        try
        {
            broadcaster.Start();
        }
        catch (BroadcasterException exception)
        {
            throw new SimulatorException(StartFailure.Describe(exception, options));
        }
    }

    private CommandServer? OpenCommands(Broadcaster broadcaster, BroadcasterOptions options)
    {
        if (result.GetValue(arguments.CommandPort) is not { } port)
            return null;

        var server = new CommandServer(broadcaster, new CommandServerOptions { Port = port, BindAddress = options.BindAddress });
        server.Failed += exception => streams.Complain($"--command-port: a command could not be answered: {exception.Message.ReplaceLineEndings(" ")}");
        try
        {
            server.Start();
            return server;
        }
        catch (BroadcasterException exception)
        {
            throw new SimulatorException(StartFailure.DescribeCommands(exception, port, options.BindAddress));
        }
    }

    private (BroadcasterOptions Options, string Description) CreateOptions()
    {
        if (arguments.Play.Read(result, result.GetValue(arguments.Rate), result.GetValue(arguments.Loop)) is { } play)
            return (SimulatorOptions.Create(arguments, result, play), TerminalText.Clean(play.Description));

        SimulatorSources sources = CreateSources();
        return (SimulatorOptions.Create(arguments, result, sources), TerminalText.Clean(sources.Description));
    }

    private SimulatorSources CreateSources()
    {
        Option<FileInfo?> option = result.GetValue(arguments.Calc) is null ? arguments.Bvh : arguments.Calc;
        var settings = new SourceSettings(
            result.GetValue(arguments.Bvh), result.GetValue(arguments.Calc), result.GetValue(arguments.Avatars) ?? 1, result.GetValue(arguments.Loop));
        return result.GetValue(option) is { } file
            ? SourceFile.Read(option.Name, file, () => SourceFactory.Create(settings))
            : SourceFactory.Create(settings);
    }
}
