using System.CommandLine;
using NeuronMocap.Benchmarks;

var frames = new Option<int>("--frames") { Description = "Frames of one run.", DefaultValueFactory = _ => 1_000_000 };
var runs = new Option<int>("--runs") { Description = "Runs of the floor and of each way, in turn.", DefaultValueFactory = _ => 7 };
var writes = new Option<int[]>("--writes")
{
    Description = "Frames that the sender hands to one write.",
    DefaultValueFactory = _ => [1, 4, 32, 256],
    AllowMultipleArgumentsPerToken = true,
};
var throughput = new Command("throughput", "Frames per second over loopback, beside a raw socket that only reads.") { frames, runs, writes };
throughput.SetAction((result, _) => Throughput.RunAsync(result.GetValue(frames), result.GetValue(runs), result.GetValue(writes)!));

var perWrite = new Option<int>("--per-write") { Required = true };
var send = new Command("send", "The sender, in its own process.") { Hidden = true };
send.Add(perWrite);
send.Add(frames);
send.SetAction(result => Sender.Run(result.GetValue(perWrite), result.GetValue(frames)));

return await new RootCommand("Measures the receive path as ratios to a floor that is measured in the same run.") { throughput, send }
    .Parse(args)
    .InvokeAsync();
