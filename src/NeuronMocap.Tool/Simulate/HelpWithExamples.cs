using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;

namespace NeuronMocap.Tool.Simulate;

/// <summary>The ordinary help, and then what to type.</summary>
internal sealed class HelpWithExamples : SynchronousCommandLineAction
{
    private readonly HelpAction _help = new();

    public override int Invoke(ParseResult parseResult)
    {
        int code = _help.Invoke(parseResult);
        parseResult.InvocationConfiguration.Output.WriteLine("""
            Examples:
              neuron-mocap simulate --bind 0.0.0.0 --avatars 2
                  Two actors for every machine of the network that connects to port 7001.
              neuron-mocap simulate --bvh take.bvh --loop --rate 60 --udp 127.0.0.1:7002 --fragment 1024
                  A take again and again, in datagrams as Axis Neuron on macOS sends them.
              neuron-mocap simulate --play take.nmrec --speed 2 --loop
                  What neuron-mocap --record wrote, byte for byte, twice as fast, again and again.
              neuron-mocap simulate --calc take_Char00.calc --calculation --loop
                  A calculation export: poses made of it, and its own values.
              neuron-mocap simulate --calculation-port
                  Motion on port 7001 and calculation on port 7003, as servers normally send them.
              neuron-mocap simulate --format text --rate 1
                  Lines to look at, with nc 127.0.0.1 7001.
              neuron-mocap simulate --commands
                  With a command channel on port 8013: neuron-mocap --commands shows what it answers.

            Exit codes: 0 done or stopped, 1 no such port, address or file, 2 bad usage.
            """);
        return code;
    }
}
