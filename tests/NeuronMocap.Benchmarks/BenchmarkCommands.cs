using System.CommandLine;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;

namespace NeuronMocap.Benchmarks;

// The options, and the commands that run on Mono, too.
internal static class BenchmarkCommands
{
    public static Option<int> Frames { get; } = new("--frames") { Description = "Frames of one run.", DefaultValueFactory = _ => 1_000_000 };

    public static Option<int> Runs { get; } =
        new("--runs") { Description = "Runs of the floor and of each way, in turn, after one that warms up.", DefaultValueFactory = _ => 7 };

    public static Option<double> Seconds { get; } = new("--seconds") { Description = "Length of one run.", DefaultValueFactory = _ => 5 };

    public static Option<FileInfo?> Json { get; } = new("--json") { Description = "Also write all figures to this file." };

    public static Option<int[]> Writes { get; } = new("--writes")
    {
        Description = "Frames that the sender hands to one write.",
        DefaultValueFactory = _ => [1, 4, 32, 256],
        AllowMultipleArgumentsPerToken = true,
    };

    public static Option<int> Connections { get; } = new("--connections");

    public static Command Throughput()
    {
        var throughput = new Command("throughput", "Frames per second over loopback TCP, by each way of delivery.") { Frames, Runs, Writes, Json };
        throughput.SetAction((result, _) => Macro.Throughput.RunAsync(result.GetValue(Frames), result.GetValue(Runs), result.GetValue(Writes)!, Open(result)));
        return throughput;
    }

    public static Command Window()
    {
        var window = new Command("window", "Delivery on a window's thread: cost of a frame there, and the wait of other messages.") { Seconds, Runs, Json };
        window.SetAction((result, _) => Macro.Window.RunAsync(result.GetValue(Seconds), result.GetValue(Runs), Open(result)));
        return window;
    }

    public static Command Flood()
    {
        var perWrite = new Option<int>("--per-write") { Required = true };
        var isPaced = new Option<bool>("--paced");
        var flood = new Command("flood", "The sender of throughput, in its own process.") { Hidden = true };
        flood.Add(perWrite);
        flood.Add(Frames);
        flood.Add(isPaced);
        flood.SetAction(result => FloodSender.Run(result.GetValue(perWrite), result.GetValue(Frames), result.GetValue(isPaced)));
        return flood;
    }

    public static Command Pace()
    {
        var udp = new Option<int?>("--udp") { Description = "The port to send to." };
        var rate = new Option<double>("--rate") { Required = true };
        var pace = new Command("pace", "The sender of latency and streams, in its own process.") { Hidden = true };
        pace.Add(Connections);
        pace.Add(udp);
        pace.Add(rate);
        pace.Add(Seconds);
        pace.SetAction(result =>
        {
            if (result.GetValue(udp) is { } toPort)
                PacedSender.RunUdp(toPort, result.GetValue(rate), result.GetValue(Seconds));
            else
                PacedSender.Run(result.GetValue(Connections), result.GetValue(rate), result.GetValue(Seconds));
        });
        return pace;
    }

    public static RootCommand Root(params Command[] commands)
    {
        var root = new RootCommand("Measures the receive path as ratios to a floor that is measured in the same run.");
        foreach (Command command in commands)
            root.Add(command);

        return root;
    }

    public static Report Open(ParseResult result) => new(result.CommandResult.Command.Name, result.GetValue(Json));
}
