using System.CommandLine;
using System.CommandLine.Help;
using System.Runtime.InteropServices;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Simulate;

/// <summary>The verb simulate: broadcasts as a server does.</summary>
internal sealed class SimulateProgram
{
    private const int Done = 0;
    private const int Failed = 1;
    private const int BadUsage = 2;
    private const string Name = "neuron-mocap";

    private readonly SimulatorCommand _command = new();

    public int Run(string[] args)
    {
        _command.Options.OfType<HelpOption>().Single().Action = new HelpWithExamples();
        _command.SetAction(Run);
        ParseResult result;
        try
        {
            result = _command.Parse(args);
        }
        catch (Exception exception)
        {
            // The parser asks this program's own checks, and whatever they throw is no reason for a stack trace.
            return Complain(UsageFault.WithHelp(Name, $"the options cannot be understood: {exception.Message}"));
        }

        if (UsageFault.Find(result, Name) is { } fault)
            return Complain(fault);

        try
        {
            // Signals are handled below, in the one place that knows what to close.
            return result.Invoke(new InvocationConfiguration { ProcessTerminationTimeout = null, EnableDefaultExceptionHandler = false });
        }
        catch (Exception exception)
        {
            // What nobody has thought of. The first line of the trace says where to look.
            string? place = exception.StackTrace?.Split('\n')[0].Trim();
            return Fail($"a fault of this program, please report it: {exception.GetType().Name}: {exception.Message} {place}");
        }
    }

    private int Run(ParseResult parsed)
    {
        try
        {
            (BroadcasterOptions options, string description) = CreateOptions(parsed);
            using Broadcaster broadcaster = OpenBroadcaster(options);
            using CommandServer? commands = OpenCommands(parsed, broadcaster, options);
            using PosixSignalRegistration interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
            using PosixSignalRegistration terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);
            Start(broadcaster, options);
            new SimulatorReport(broadcaster, commands, options, description).Run();
            return Done;

            void Stop(PosixSignalContext context)
            {
                context.Cancel = true;
                broadcaster.Stop();
            }
        }
        catch (UsageException exception)
        {
            return Complain(UsageFault.WithHelp(Name, exception.Message));
        }
        catch (SimulatorException exception)
        {
            return Fail(exception.Message);
        }
        catch (IOException exception)
        {
            return Fail($"standard output cannot be written: {exception.Message}");
        }
    }

    private Broadcaster OpenBroadcaster(BroadcasterOptions options)
    {
        try
        {
            return new Broadcaster(options);
        }
        catch (ArgumentException exception) when (exception.ParamName is nameof(BroadcasterOptions.Rate))
        {
            throw new SimulatorException("--rate: the file's own rate is not from 0.01 to 100000 Hz; give one.");
        }
        catch (Exception exception) when (exception is NeuronException or IOException or UnauthorizedAccessException)
        {
            // It was there a moment ago.
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

    private CommandServer? OpenCommands(ParseResult parsed, Broadcaster broadcaster, BroadcasterOptions options)
    {
        if (parsed.GetValue(_command.Commands) is not { } port)
            return null;

        var server = new CommandServer(broadcaster, new CommandServerOptions { Port = port, BindAddress = options.BindAddress });
        server.Failed += exception => Console.Error.WriteLine($"{Name}: --commands: a command could not be answered: {exception.Message.ReplaceLineEndings(" ")}");
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

    private (BroadcasterOptions Options, string Description) CreateOptions(ParseResult parsed)
    {
        if (_command.Play.Read(parsed, parsed.GetValue(_command.Rate), parsed.GetValue(_command.Loop)) is { } play)
            return (SimulatorOptions.Create(_command, parsed, play), TerminalText.Clean(play.Description));

        SimulatorSources sources = CreateSources(parsed);
        return (SimulatorOptions.Create(_command, parsed, sources), TerminalText.Clean(sources.Description));
    }

    private SimulatorSources CreateSources(ParseResult parsed)
    {
        Option<FileInfo?> option = parsed.GetValue(_command.Calc) is null ? _command.Bvh : _command.Calc;
        var settings = new SourceSettings(
            parsed.GetValue(_command.Bvh), parsed.GetValue(_command.Calc), parsed.GetValue(_command.Avatars) ?? 1, parsed.GetValue(_command.Loop));
        return parsed.GetValue(option) is { } file
            ? SourceFile.Read(option.Name, file, () => SourceFactory.Create(settings))
            : SourceFactory.Create(settings);
    }

    private static int Complain(string message)
    {
        Console.Error.WriteLine($"{Name}: {message}");
        return BadUsage;
    }

    private static int Fail(string message)
    {
        Console.Error.WriteLine(TerminalText.Clean($"{Name}: {message.ReplaceLineEndings(" ")}"));
        return Failed;
    }
}
