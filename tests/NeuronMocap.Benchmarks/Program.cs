using System.CommandLine;
using BenchmarkDotNet.Running;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Macro;
using NeuronMocap.Benchmarks.Micro;
using NeuronMocap.Benchmarks.Peers;

var frames = new Option<int>("--frames") { Description = "Frames of one run.", DefaultValueFactory = _ => 1_000_000 };
var runs = new Option<int>("--runs") { Description = "Runs of the floor and of each way, in turn, after one that warms up.", DefaultValueFactory = _ => 7 };
var seconds = new Option<double>("--seconds") { Description = "Length of one run.", DefaultValueFactory = _ => 5 };
var json = new Option<FileInfo?>("--json") { Description = "Also write all figures to this file." };
var writes = new Option<int[]>("--writes")
{
    Description = "Frames that the sender hands to one write.",
    DefaultValueFactory = _ => [1, 4, 32, 256],
    AllowMultipleArgumentsPerToken = true,
};

var throughput = new Command("throughput", "Frames per second over loopback TCP, by each way of delivery.") { frames, runs, writes, json };
throughput.SetAction((result, _) => Throughput.RunAsync(result.GetValue(frames), result.GetValue(runs), result.GetValue(writes)!, Open(result)));

var avatars = new Command("avatars", "Cost of a frame with several avatars in one stream.") { runs, json };
avatars.SetAction((result, _) => Scaling.AvatarsAsync([10, 100], result.GetValue(runs), Open(result)));

var consumers = new Command("consumers", "Cost of a frame with several consumers.") { runs, json };
consumers.SetAction((result, _) => Scaling.ConsumersAsync([4, 16], result.GetValue(runs), Open(result)));

var clients = new Option<int[]>("--clients") { Description = "Numbers of clients.", DefaultValueFactory = _ => [1, 10, 100], AllowMultipleArgumentsPerToken = true };
var broadcast = new Command("broadcast", "Cost and speed of the server.") { clients, seconds, runs, json };
broadcast.SetAction((result, _) => Broadcast.RunAsync(result.GetValue(clients)!, result.GetValue(seconds), result.GetValue(runs), Open(result)));

var decode = new Command("decode", "Cost of a frame without a network: scan, decode, publish, take.") { runs, json };
decode.SetAction((result, _) => Decode.RunAsync(result.GetValue(runs), Open(result)));

var kinematics = new Command("kinematics", "Cost of a frame from its values to world transforms, velocities, contacts and retimed poses.") { runs, json };
kinematics.SetAction((result, _) => PoseCost.RunAsync(result.GetValue(runs), Open(result)));

var retarget = new Command("retarget", "Cost of a frame on a Humanoid character: rotations, places, feet that stand.") { runs, json };
retarget.SetAction((result, _) => RetargetCost.RunAsync(result.GetValue(runs), Open(result)));

var recording = new Command("record", "What a recording costs the receive thread.") { runs, json };
recording.SetAction((result, _) => Record.RunAsync(result.GetValue(runs), Open(result)));

var rates = new Option<double[]>("--rates") { Description = "Frames per second.", DefaultValueFactory = _ => [60, 120, 1000], AllowMultipleArgumentsPerToken = true };
var latency = new Command("latency", "Time from send to the handler, one frame at a time.") { rates, seconds, runs, json };
latency.SetAction((result, _) => Latency.RunAsync(result.GetValue(rates)!, result.GetValue(seconds), result.GetValue(runs), Open(result)));

var counts = new Option<int[]>("--counts") { Description = "Numbers of connections.", DefaultValueFactory = _ => [10, 100, 1000], AllowMultipleArgumentsPerToken = true };
var streams = new Command("streams", "Cost of many connections in one process.") { counts, seconds, runs, json };
streams.SetAction((result, _) => Streams.RunAsync(result.GetValue(counts)!, result.GetValue(seconds), result.GetValue(runs), Open(result)));

var megabytes = new Option<int>("--megabytes") { Description = "Size of the file.", DefaultValueFactory = _ => 100 };
var bvh = new Command("bvh", "Reading a BVH file, row by row and as a document.") { megabytes, runs, json };
bvh.SetAction((result, _) => BvhFiles.RunAsync(result.GetValue(megabytes), result.GetValue(runs), Open(result)));

var speeds = new Option<double[]>("--speeds") { Description = "Speeds.", DefaultValueFactory = _ => [1, 4], AllowMultipleArgumentsPerToken = true };
var playback = new Command("playback", "How exactly a recording is played, and what it costs.") { speeds, seconds, json };
playback.SetAction((result, _) => Playback.RunAsync(result.GetValue(speeds)!, result.GetValue(seconds), Open(result)));

var window = new Command("window", "Delivery on a window's thread: cost of a frame there, and the wait of other messages.") { seconds, runs, json };
window.SetAction((result, _) => Window.RunAsync(result.GetValue(seconds), result.GetValue(runs), Open(result)));

var micro = new Command("micro", "The steps of the receive path one by one, by BenchmarkDotNet.");
micro.SetAction(_ => { BenchmarkRunner.Run<ReceivePathBenchmarks>(ReceivePathBenchmarks.Config); });

var programs = new Option<DirectoryInfo>("--programs") { Description = "Where bench-raw and bench-library are: tests/native, built.", Required = true };
var nativeWrites = new Option<int[]>("--writes")
{
    Description = "Frames that the sender hands to one write.",
    DefaultValueFactory = _ => [8, 32, 256],
    AllowMultipleArgumentsPerToken = true,
};
var native = new Command("native", "The C library: frames per second, latency, start.") { programs, frames, runs, nativeWrites, rates, seconds, json };
native.SetAction((result, _) => new Native(result.GetValue(programs)!, result.GetValue(runs), Open(result))
    .RunAsync(result.GetValue(frames), result.GetValue(nativeWrites)!, result.GetValue(rates)!, result.GetValue(seconds)));

var perWrite = new Option<int>("--per-write") { Required = true };
var flood = new Command("flood", "The sender of throughput, in its own process.") { Hidden = true };
flood.Add(perWrite);
flood.Add(frames);
flood.SetAction(result => FloodSender.Run(result.GetValue(perWrite), result.GetValue(frames)));

var connections = new Option<int>("--connections");
var udp = new Option<int?>("--udp") { Description = "The port to send to." };
var rate = new Option<double>("--rate") { Required = true };
var pace = new Command("pace", "The sender of latency and streams, in its own process.") { Hidden = true };
pace.Add(connections);
pace.Add(udp);
pace.Add(rate);
pace.Add(seconds);
pace.SetAction(result =>
{
    if (result.GetValue(udp) is { } toPort)
        PacedSender.RunUdp(toPort, result.GetValue(rate), result.GetValue(seconds));
    else
        PacedSender.Run(result.GetValue(connections), result.GetValue(rate), result.GetValue(seconds));
});

var port = new Option<int>("--port") { Required = true };
var idler = new Option<bool>("--idler");
var sinks = new Command("sinks", "The clients of broadcast, in their own process.") { Hidden = true };
sinks.Add(port);
sinks.Add(connections);
sinks.Add(idler);
sinks.SetAction(result => Sinks.Run(result.GetValue(port), result.GetValue(connections), result.GetValue(idler)));

var root = new RootCommand("Measures the receive path as ratios to a floor that is measured in the same run.")
{
    throughput, latency, streams, avatars, consumers, broadcast, decode, bvh, kinematics, retarget, recording, playback, window, native, micro, flood, pace, sinks,
};
#if UNITY_PACKAGE
var unity = new Command("unity", "Cost of a rendered frame of the Unity package in the tests' stand-in of the engine.") { runs, json };
unity.SetAction((result, _) => UnityFrames.RunAsync(result.GetValue(runs), Open(result)));
root.Add(unity);
#endif
return await root.Parse(args).InvokeAsync();

Report Open(ParseResult result) => new(result.CommandResult.Command.Name, result.GetValue(json));
