using System.CommandLine;
using System.CommandLine.Help;
using System.Runtime.InteropServices;
using NeuronMocap;
using NeuronMocap.Server;
using NeuronMocap.Simulator;

const int Done = 0;
const int Failed = 1;
const int BadUsage = 2;

var command = new SimulatorCommand();
command.Options.OfType<HelpOption>().Single().Action = new HelpWithExamples();
command.SetAction(Run);
ParseResult result = command.Parse(args);
if (result.Errors.Count > 0)
    return Complain(string.Join(Environment.NewLine, result.Errors.Select(error => error.Message)));

// Signals are handled below, in the one place that knows what to close.
return result.Invoke(new InvocationConfiguration { ProcessTerminationTimeout = null, EnableDefaultExceptionHandler = false });

int Run(ParseResult parsed)
{
    try
    {
        (BroadcasterOptions options, string description) = CreateOptions(parsed);
        using var broadcaster = new Broadcaster(options);
        using CommandServer? commands = OpenCommands(parsed, broadcaster, options);
        using PosixSignalRegistration interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
        using PosixSignalRegistration terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);
        broadcaster.Start();
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
        return Complain(exception.Message);
    }
    catch (SimulatorException exception)
    {
        return Fail(exception.Message);
    }
    catch (IOException exception)
    {
        return Fail($"standard output cannot be written: {exception.Message}");
    }
    catch (BroadcasterException exception)
    {
        return Fail($"{OptionOf(exception.Setting)}: {exception.Message}");
    }
}

CommandServer? OpenCommands(ParseResult parsed, Broadcaster broadcaster, BroadcasterOptions options)
{
    if (parsed.GetValue(command.Commands) is not { } port)
        return null;

    var server = new CommandServer(broadcaster, new CommandServerOptions { Port = port, BindAddress = options.BindAddress });
    try
    {
        server.Start();
        return server;
    }
    catch (BroadcasterException exception)
    {
        throw new SimulatorException($"--commands: {exception.Message}");
    }
}

(BroadcasterOptions Options, string Description) CreateOptions(ParseResult parsed)
{
    if (command.Play.Read(parsed, parsed.GetValue(command.Rate), parsed.GetValue(command.Loop)) is { } play)
        return (SimulatorOptions.Create(command, parsed, play), play.Description);

    SimulatorSources sources = CreateSources(parsed);
    return (SimulatorOptions.Create(command, parsed, sources), sources.Description);
}

SimulatorSources CreateSources(ParseResult parsed)
{
    try
    {
        return SourceFactory.Create(new SourceSettings(
            parsed.GetValue(command.Bvh), parsed.GetValue(command.Calc), parsed.GetValue(command.Avatars) ?? 1, parsed.GetValue(command.Loop)));
    }
    catch (Exception exception) when (exception is NeuronException or IOException or UnauthorizedAccessException)
    {
        string option = parsed.GetValue(command.Calc) is null ? command.Bvh.Name : command.Calc.Name;
        throw new SimulatorException($"{option}: {exception.Message}");
    }
}

int Complain(string message)
{
    Console.Error.WriteLine(message);
    Console.Error.WriteLine(command.Usage);
    return BadUsage;
}

static int Fail(string message)
{
    Console.Error.WriteLine(message.ReplaceLineEndings(" "));
    return Failed;
}

static string OptionOf(string setting) => setting switch
{
    nameof(BroadcasterOptions.Port) => "--port",
    nameof(BroadcasterOptions.BindAddress) => "--bind",
    _ => "--udp",
};
