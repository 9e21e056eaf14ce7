using System.CommandLine;
using System.CommandLine.Help;
using System.Runtime.InteropServices;
using NeuronMocap;
using NeuronMocap.Monitor;
using NeuronMocap.Server;
using NeuronMocap.Simulator;

const int Done = 0;
const int Failed = 1;
const int BadUsage = 2;
const string Name = "neuron-simulator";

var command = new SimulatorCommand();
command.Options.OfType<HelpOption>().Single().Action = new HelpWithExamples();
command.SetAction(Run);
ParseResult result;
try
{
    result = command.Parse(args);
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

int Run(ParseResult parsed)
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

Broadcaster OpenBroadcaster(BroadcasterOptions options)
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

static void Start(Broadcaster broadcaster, BroadcasterOptions options)
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

CommandServer? OpenCommands(ParseResult parsed, Broadcaster broadcaster, BroadcasterOptions options)
{
    if (parsed.GetValue(command.Commands) is not { } port)
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

(BroadcasterOptions Options, string Description) CreateOptions(ParseResult parsed)
{
    if (command.Play.Read(parsed, parsed.GetValue(command.Rate), parsed.GetValue(command.Loop)) is { } play)
        return (SimulatorOptions.Create(command, parsed, play), TerminalText.Clean(play.Description));

    SimulatorSources sources = CreateSources(parsed);
    return (SimulatorOptions.Create(command, parsed, sources), TerminalText.Clean(sources.Description));
}

SimulatorSources CreateSources(ParseResult parsed)
{
    Option<FileInfo?> option = parsed.GetValue(command.Calc) is null ? command.Bvh : command.Calc;
    var settings = new SourceSettings(
        parsed.GetValue(command.Bvh), parsed.GetValue(command.Calc), parsed.GetValue(command.Avatars) ?? 1, parsed.GetValue(command.Loop));
    return parsed.GetValue(option) is { } file
        ? SourceFile.Read(option.Name, file, () => SourceFactory.Create(settings))
        : SourceFactory.Create(settings);
}

static int Complain(string message)
{
    Console.Error.WriteLine($"{Name}: {message}");
    return BadUsage;
}

static int Fail(string message)
{
    Console.Error.WriteLine(TerminalText.Clean($"{Name}: {message.ReplaceLineEndings(" ")}"));
    return Failed;
}
