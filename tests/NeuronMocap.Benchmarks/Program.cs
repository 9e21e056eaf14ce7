using System.CommandLine;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Macro;
using NeuronMocap.Benchmarks.Peers;

var frames = new Option<int>("--frames") { Description = "Frames of one run.", DefaultValueFactory = _ => 1_000_000 };
var runs = new Option<int>("--runs") { Description = "Runs of the floor and of each way, in turn, after one that warms up.", DefaultValueFactory = _ => 7 };
var json = new Option<FileInfo?>("--json") { Description = "Also write all figures to this file." };
var writes = new Option<int[]>("--writes")
{
    Description = "Frames that the sender hands to one write.",
    DefaultValueFactory = _ => [1, 4, 32, 256],
    AllowMultipleArgumentsPerToken = true,
};

var throughput = new Command("throughput", "Frames per second over loopback TCP, by each way of delivery.") { frames, runs, writes, json };
throughput.SetAction((result, _) => Throughput.RunAsync(result.GetValue(frames), result.GetValue(runs), result.GetValue(writes)!, Open(result)));

var decode = new Command("decode", "Cost of a frame without a network: scan, decode, publish, take.") { runs, json };
decode.SetAction((result, _) => Decode.RunAsync(result.GetValue(runs), Open(result)));

var rates = new Option<double[]>("--rates") { Description = "Frames per second.", DefaultValueFactory = _ => [60, 120, 1000], AllowMultipleArgumentsPerToken = true };
var seconds = new Option<double>("--seconds") { Description = "Length of one run.", DefaultValueFactory = _ => 5 };
var latency = new Command("latency", "Time from send to the handler, one frame at a time.") { rates, seconds, runs, json };
latency.SetAction((result, _) => Latency.RunAsync(result.GetValue(rates)!, result.GetValue(seconds), result.GetValue(runs), Open(result)));

var counts = new Option<int[]>("--counts") { Description = "Numbers of connections.", DefaultValueFactory = _ => [10, 100, 1000], AllowMultipleArgumentsPerToken = true };
var streams = new Command("streams", "Cost of many connections in one process.") { counts, seconds, runs, json };
streams.SetAction((result, _) => Streams.RunAsync(result.GetValue(counts)!, result.GetValue(seconds), result.GetValue(runs), Open(result)));

var perWrite = new Option<int>("--per-write") { Required = true };
var flood = new Command("flood", "The sender of throughput, in its own process.") { Hidden = true };
flood.Add(perWrite);
flood.Add(frames);
flood.SetAction(result => FloodSender.Run(result.GetValue(perWrite), result.GetValue(frames)));

var connections = new Option<int>("--connections") { Required = true };
var rate = new Option<double>("--rate") { Required = true };
var pace = new Command("pace", "The sender of latency and streams, in its own process.") { Hidden = true };
pace.Add(connections);
pace.Add(rate);
pace.Add(seconds);
pace.SetAction(result => PacedSender.Run(result.GetValue(connections), result.GetValue(rate), result.GetValue(seconds)));

return await new RootCommand("Measures the receive path as ratios to a floor that is measured in the same run.") { throughput, latency, streams, decode, flood, pace }
    .Parse(args)
    .InvokeAsync();

Report Open(ParseResult result) => new(result.CommandResult.Command.Name, result.GetValue(json));
