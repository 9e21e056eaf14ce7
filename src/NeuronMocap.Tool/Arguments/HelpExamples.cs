using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;

namespace NeuronMocap.Tool.Arguments;

/// <summary>What stands below the list of options in --help.</summary>
internal sealed class HelpExamples(SynchronousCommandLineAction help) : SynchronousCommandLineAction
{
    private const string Text = """
        Keys of the live view:
          q quit   space pause   r reset counters   tab next avatar   b next bones   ? help
          with --play, too: . , frame by frame   left, right 5 s back, forward   + - 0 speed

        Exit codes:
          0  done as asked, or ended by q, Ctrl+C or SIGTERM
          1  nothing was received, or a file could not be read or written; standard error says which setting to look at
          2  wrong options
          Of --commands: 0 answered, 1 not, 2 wrong options, 130 ended by Ctrl+C or SIGTERM before it knew
          Of --info, --convert, --plot: 0 done, 1 not read or written, 2 wrong options, 130 ended by Ctrl+C or SIGTERM, nothing written
          Of --diagnose: 0 frames arrive, 1 a fault was found, 2 wrong options, 130 ended by Ctrl+C or SIGTERM before it knew

        Examples:
          neuron-mocap                                        a moving skeleton, without suit or server
          neuron-mocap 192.168.1.20                           Axis Neuron on another computer, TCP port 7001
          neuron-mocap --connect [::1]:7003 --order XYZ       IPv6, another port, another rotation order
          neuron-mocap --udp 7012                             Axis Neuron set to UDP, with this computer as destination
          neuron-mocap udp://192.168.1.5:7012                 the same on one network of several; 192.168.1.5 is this computer
          neuron-mocap --udp 7012 --allow-sender 192.168.1.20 the same, and nobody else may send
          neuron-mocap 192.168.1.20 --calculation-port 7003   calculation data as well, from their own port
          neuron-mocap --diagnose 192.168.1.20                no data? What is wrong, and which setting to change
          neuron-mocap --diagnose --udp 7012                  the same for UDP; with --demo it shows a healthy stream
          neuron-mocap --commands 192.168.1.20                bone sizes, rotation order and BVH header; port 8013
          neuron-mocap --commands 192.168.1.20 --zero-out 0   zeroes out avatar 0; all for all of them
          neuron-mocap --play take.nmrec --speed 0.5          a recording, half as fast
          neuron-mocap --play dump.bin --rate 60 --json       frames of bytes that somebody wrote to a file
          neuron-mocap --connect studio --export take.bvh     keep what is shown, until q or Ctrl+C
          neuron-mocap --info take.bvh                        what a file holds, and what is odd about it; also .nmrec, .calc, .bin
          neuron-mocap --convert take.nmrec take.bvh          a recording as BVH; a file of any kind as any other
          neuron-mocap --convert a.bvh b.bvh --from 2 --to 5  a part of a take; also --resample 60, --order XYZ
          neuron-mocap --plot take.bvh take.svg               a picture of a take
          neuron-mocap --convert dump.bin take.bvh --rate 60  bytes that somebody wrote to a file, at 60 frames per second
          neuron-mocap --connect studio --json --frames 100   100 frames for another program
          neuron-mocap --connect studio --record take.nmrec   show it and keep every byte of it
          neuron-mocap --connect studio --quiet --duration 10 does anything arrive? The exit code tells

        """;

    public static void AddTo(RootCommand root)
    {
        HelpOption option = root.Options.OfType<HelpOption>().Single();
        option.Action = new HelpExamples((SynchronousCommandLineAction)option.Action!);
    }

    public override int Invoke(ParseResult parseResult)
    {
        int exitCode = help.Invoke(parseResult);
        parseResult.InvocationConfiguration.Output.Write(Text);
        return exitCode;
    }
}
