using System.CommandLine;
using BenchmarkDotNet.Running;
using NeuronMocap.Benchmarks.Macro;
using NeuronMocap.Benchmarks.Micro;
using NeuronMocap.Benchmarks.Peers;
using static NeuronMocap.Benchmarks.BenchmarkCommands;

var avatars = new Command("avatars", "Cost of a frame with several avatars in one stream.") { Runs, Json };
avatars.SetAction((result, _) => Scaling.AvatarsAsync([10, 100], result.GetValue(Runs), Open(result)));

var consumers = new Command("consumers", "Cost of a frame with several consumers.") { Runs, Json };
consumers.SetAction((result, _) => Scaling.ConsumersAsync([4, 16], result.GetValue(Runs), Open(result)));

var clients = new Option<int[]>("--clients") { Description = "Numbers of clients.", DefaultValueFactory = _ => [1, 10, 100], AllowMultipleArgumentsPerToken = true };
var broadcast = new Command("broadcast", "Cost and speed of the server.") { clients, Seconds, Runs, Json };
broadcast.SetAction((result, _) => Broadcast.RunAsync(result.GetValue(clients)!, result.GetValue(Seconds), result.GetValue(Runs), Open(result)));

var rates = new Option<double[]>("--rates") { Description = "Frames per second.", DefaultValueFactory = _ => [60, 120, 1000], AllowMultipleArgumentsPerToken = true };
var relay = new Command("relay", "What a relay adds from server to client, and its speed.") { rates, Frames, Seconds, Runs, Json };
relay.SetAction((result, _) => Relay.RunAsync(result.GetValue(rates)!, result.GetValue(Frames), result.GetValue(Seconds), result.GetValue(Runs), Open(result)));

var decode = new Command("decode", "Cost of a frame without a network: scan, decode, publish, take.") { Runs, Json };
decode.SetAction((result, _) => Decode.RunAsync(result.GetValue(Runs), Open(result)));

var kinematics = new Command("kinematics", "Cost of a frame from its values to world transforms, velocities, contacts and retimed poses.") { Runs, Json };
kinematics.SetAction((result, _) => PoseCost.RunAsync(result.GetValue(Runs), Open(result)));

var messages = new Command("messages", "Cost of a pose for other programs: compact, VMC and OSC.") { Runs, Json };
messages.SetAction((result, _) => PoseMessages.RunAsync(result.GetValue(Runs), Open(result)));

var retarget = new Command("retarget", "Cost of a frame on a Humanoid character: rotations, places, feet that stand.") { Runs, Json };
retarget.SetAction((result, _) => RetargetCost.RunAsync(result.GetValue(Runs), Open(result)));

var recording = new Command("record", "What a recording costs the receive thread.") { Runs, Json };
recording.SetAction((result, _) => Record.RunAsync(result.GetValue(Runs), Open(result)));

var latency = new Command("latency", "Time from send to the handler, one frame at a time.") { rates, Seconds, Runs, Json };
latency.SetAction((result, _) => Latency.RunAsync(result.GetValue(rates)!, result.GetValue(Seconds), result.GetValue(Runs), Open(result)));

var counts = new Option<int[]>("--counts") { Description = "Numbers of connections.", DefaultValueFactory = _ => [10, 100, 1000], AllowMultipleArgumentsPerToken = true };
var streams = new Command("streams", "Cost of many connections in one process.") { counts, Seconds, Runs, Json };
streams.SetAction((result, _) => Streams.RunAsync(result.GetValue(counts)!, result.GetValue(Seconds), result.GetValue(Runs), Open(result)));

var megabytes = new Option<int>("--megabytes") { Description = "Size of the file.", DefaultValueFactory = _ => 100 };
var bvh = new Command("bvh", "Reading a BVH file, row by row and as a document.") { megabytes, Runs, Json };
bvh.SetAction((result, _) => BvhFiles.RunAsync(result.GetValue(megabytes), result.GetValue(Runs), Open(result)));

var speeds = new Option<double[]>("--speeds") { Description = "Speeds.", DefaultValueFactory = _ => [1, 4], AllowMultipleArgumentsPerToken = true };
var playback = new Command("playback", "How exactly a recording is played, and what it costs.") { speeds, Seconds, Json };
playback.SetAction((result, _) => Playback.RunAsync(result.GetValue(speeds)!, result.GetValue(Seconds), Open(result)));

var micro = new Command("micro", "The steps of the receive path one by one, by BenchmarkDotNet.");
micro.SetAction(_ => { BenchmarkRunner.Run<ReceivePathBenchmarks>(ReceivePathBenchmarks.Config); });

var programs = new Option<DirectoryInfo>("--programs") { Description = "Where bench-raw and bench-library are: tests/native, built.", Required = true };
var nativeWrites = new Option<int[]>("--writes")
{
    Description = "Frames that the sender hands to one write.",
    DefaultValueFactory = _ => [8, 32, 256],
    AllowMultipleArgumentsPerToken = true,
};
var native = new Command("native", "The C library: frames per second, latency, start.") { programs, Frames, Runs, nativeWrites, rates, Seconds, Json };
native.SetAction((result, _) => new Native(result.GetValue(programs)!, result.GetValue(Runs), Open(result))
    .RunAsync(result.GetValue(Frames), result.GetValue(nativeWrites)!, result.GetValue(rates)!, result.GetValue(Seconds)));

var port = new Option<int>("--port") { Required = true };
var idler = new Option<bool>("--idler");
var sinks = new Command("sinks", "The clients of broadcast, in their own process.") { Hidden = true };
sinks.Add(port);
sinks.Add(Connections);
sinks.Add(idler);
sinks.SetAction(result => Sinks.Run(result.GetValue(port), result.GetValue(Connections), result.GetValue(idler)));

RootCommand root = Root(
    Throughput(), latency, streams, avatars, consumers, broadcast, relay, decode, bvh, kinematics, messages, retarget, recording, playback, Window(), native, micro,
    Flood(), Pace(), sinks);
#if PIPES
var connections = new Option<int>("--connections") { Description = "Connections of the paced case.", DefaultValueFactory = _ => 100 };
var pipe = new Command("pipe", "Streams and pipes as sources, against the connection itself.") { Frames, Runs, Writes, connections, Seconds, Json };
pipe.SetAction((result, _) => Pipes.RunAsync(
    result.GetValue(Frames), result.GetValue(Runs), result.GetValue(Writes)!, result.GetValue(connections), result.GetValue(Seconds), Open(result)));
root.Add(pipe);

var webClients = new Option<int[]>("--clients") { Description = "Numbers of clients.", DefaultValueFactory = _ => [50], AllowMultipleArgumentsPerToken = true };
var web = new Command("web", "Cost and delay of WebSocket clients.") { webClients, Seconds, Runs, Json };
web.SetAction((result, _) => Web.RunAsync(result.GetValue(webClients)!, result.GetValue(Seconds), result.GetValue(Runs), Open(result)));
root.Add(web);

var form = new Option<string>("--form") { Required = true };
var webSinks = new Command("websinks", "The clients of web, in their own process.") { Hidden = true };
webSinks.Add(port);
webSinks.Add(Connections);
webSinks.Add(form);
webSinks.SetAction(result => WebSinks.RunAsync(result.GetValue(port), result.GetValue(Connections), result.GetValue(form)!));
root.Add(webSinks);
var avatarCount = new Option<int>("--avatars") { Description = "Avatars, each with 60 frames per second.", DefaultValueFactory = _ => 100 };
var consumerCount = new Option<int>("--consumers") { Description = "Readers of the broker.", DefaultValueFactory = _ => 4 };
var rabbit = new Command("rabbit", "Frames over a RabbitMQ broker, which this command starts and ends.") { avatarCount, consumerCount, Runs, Seconds, Json };
rabbit.SetAction((result, _) => Rabbit.RunAsync(
    result.GetValue(avatarCount), result.GetValue(consumerCount), result.GetValue(Seconds), result.GetValue(Runs), Open(result)));
root.Add(rabbit);
#endif
#if UNITY_PACKAGE
var unity = new Command("unity", "Cost of a rendered frame of the Unity package in the tests' stand-in of the engine.") { Runs, Json };
unity.SetAction((result, _) => UnityFrames.RunAsync(result.GetValue(Runs), Open(result)));
root.Add(unity);
#endif
return await root.Parse(args).InvokeAsync();
