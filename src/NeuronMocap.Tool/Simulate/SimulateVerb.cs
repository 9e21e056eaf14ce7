using System.CommandLine;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Simulate;

/// <summary>neuron-mocap simulate: acts as a server.</summary>
internal sealed class SimulateVerb : Verb
{
    private readonly SimulateArguments _arguments = new();

    public SimulateVerb()
        : base("simulate", "Broadcast like Axis Neuron, without a suit, to any number of TCP clients and UDP receivers.")
    {
        foreach ((string title, Option[] options) in _arguments.Sections)
            AddOptions(title, options);

        Validators.Add(_arguments.RejectContradictions);
    }

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("simulate --bind 0.0.0.0 --avatars 2", "two avatars for every computer of the network that connects to port 7001"),
        new("simulate --bvh take.bvh --loop --rate 60 --udp 127.0.0.1:7002 --fragment 1024", "a take in a loop, in datagrams as Axis Neuron on macOS sends them"),
        new("simulate --play take.nmrec --speed 2 --loop", "a recording of watch --record, byte for byte, twice as fast, in a loop"),
        new("simulate --calc take_Char00.calc --calculation --loop", "a calculation export: poses computed from it, and its own values"),
        new("simulate --calculation-port", "motion on port 7001 and calculation on port 7003, as servers normally send them"),
        new("simulate --format text --rate 1", "lines of text; read them with nc 127.0.0.1 7001"),
        new("simulate --command-port", "with a command channel on port 8013: the verb command shows what it answers"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes { get; } =
    [
        (ToolCommand.Done, "done, or stopped by Ctrl+C or SIGTERM"),
        (ToolCommand.NothingReceived, "a port, an address or a file is not available"),
        (ToolCommand.Interrupted, "ended by Ctrl+C or SIGTERM before it began"),
    ];

    public override async Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken)
    {
        try
        {
            await new SimulateRun(_arguments, result, streams).RunAsync(cancellationToken);
            return ToolCommand.Done;
        }
        catch (UsageException exception)
        {
            return await RefuseAsync(streams, exception.Message);
        }
        catch (SimulatorException exception)
        {
            await streams.ComplainAsync(exception.Message.ReplaceLineEndings(" "));
            return ToolCommand.NothingReceived;
        }
        catch (OperationCanceledException)
        {
            return ToolCommand.Interrupted;
        }
    }
}
