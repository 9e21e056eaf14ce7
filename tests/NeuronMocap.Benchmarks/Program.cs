using System.CommandLine;
using BenchmarkDotNet.Running;
using NeuronMocap.Benchmarks.Macro;
using NeuronMocap.Benchmarks.Micro;
using NeuronMocap.Benchmarks.Page;
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

var idleCounts = new Option<int[]>("--counts") { Description = "Numbers of connections.", DefaultValueFactory = _ => [1, 100], AllowMultipleArgumentsPerToken = true };
var settle = new Option<double>("--settle") { Description = "Seconds before each run.", DefaultValueFactory = _ => 60 };
var idle = new Command("idle", "Wake-ups and processor time of connections that deliver nothing.") { idleCounts, settle, Seconds, Runs, Json };
idle.SetAction((result, _) => Idle.RunAsync(
    result.GetValue(idleCounts)!, result.GetValue(settle), result.GetValue(Seconds), result.GetValue(Runs), Open(result)));

var silent = new Command("silent", "The server of idle, in its own process.") { Hidden = true };
silent.Add(Connections);
silent.SetAction(result => SilentServer.Run(result.GetValue(Connections)));

var megabytes = new Option<int>("--megabytes") { Description = "Size of the file.", DefaultValueFactory = _ => 100 };
var bvh = new Command("bvh", "Reading a BVH file, row by row and as a document.") { megabytes, Runs, Json };
bvh.SetAction((result, _) => BvhFiles.RunAsync(result.GetValue(megabytes), result.GetValue(Runs), Open(result)));

var speeds = new Option<double[]>("--speeds") { Description = "Speeds.", DefaultValueFactory = _ => [1, 4], AllowMultipleArgumentsPerToken = true };
var playback = new Command("playback", "How exactly a recording is played, and what it costs.") { speeds, Seconds, Runs, Json };
playback.SetAction((result, _) => Playback.RunAsync(result.GetValue(speeds)!, result.GetValue(Seconds), result.GetValue(Runs), Open(result)));

var senders = new Option<int[]>("--senders") { Description = "Numbers of senders.", DefaultValueFactory = _ => [1, 16], AllowMultipleArgumentsPerToken = true };
var udp = new Command("udp", "Datagrams per second and their loss.") { senders, Frames, Runs, Json };
udp.SetAction((result, _) => Udp.RunAsync(result.GetValue(senders)!, result.GetValue(Frames), result.GetValue(Runs), Open(result)));

var growthCounts = new Option<int[]>("--counts") { Description = "Numbers, the smallest of which is the floor.", DefaultValueFactory = _ => [1, 10, 100, 1000], AllowMultipleArgumentsPerToken = true };
var hours = new Option<double[]>("--hours") { Description = "Lengths of recordings.", DefaultValueFactory = _ => [0.1, 1, 10], AllowMultipleArgumentsPerToken = true };
var growthTool = new Option<FileInfo?>("--tool") { Description = "neuron-mocap.dll, whose command info is measured." };
var growth = new Command("growth", "Cost of a frame as connections, avatars, consumers, clients and recordings grow.") { growthCounts, hours, growthTool, Seconds, Runs, Json };
growth.SetAction((result, _) => Growth.RunAsync(
    result.GetValue(growthCounts)!, result.GetValue(hours)!, result.GetValue(growthTool), result.GetValue(Seconds), result.GetValue(Runs), Open(result)));

var raw = new Option<FileInfo>("--raw") { Description = "bench-raw of tests/native.", Required = true };
var peers = new Command("peers", "The same stream through a receive loop in C, a client as tutorials write it, and the library.") { raw, Frames, Runs, Writes, rates, Seconds, Json };
peers.SetAction((result, _) => new Clients(result.GetValue(raw)!, result.GetValue(Runs), Open(result))
    .RunAsync(result.GetValue(Frames), result.GetValue(Writes)!, result.GetValue(rates)!, result.GetValue(Seconds)));

var page = new Option<FileInfo?>("--page") { Description = "performance.md." };
var checkRuns = new Option<int>("--runs") { Description = "Runs of the floor and of each way.", DefaultValueFactory = _ => 3 };
var check = new Command("check", "Fails if a frame costs three times as much as the page says, in ratios of processor time.") { page, checkRuns, Json };
check.SetAction((result, _) => Check.RunAsync(result.GetValue(checkRuns), result.GetValue(page), Open(result)));

var results = new Option<DirectoryInfo>("--results") { Description = "The folder that measure.sh wrote.", Required = true };
var update = new Command("page", "Writes results into performance.md, and its curves beside it.") { results, page };
update.SetAction(result => PageUpdate.Run(result.GetValue(results)!, result.GetValue(page)!));

var starts = new Option<DirectoryInfo>("--programs") { Description = "Where the programs are that publish-starts.sh made.", Required = true };
var start = new Command("start", "From the start of a process to its first frame, and to the program's first picture.") { starts, Runs, Json };
start.SetAction((result, _) => new Start(result.GetValue(starts)!, result.GetValue(Runs), Open(result)).RunAsync());

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
var floodUdp = new Command("floodudp", "The senders of udp, in their own process.") { Hidden = true };
floodUdp.Add(port);
floodUdp.Add(Connections);
floodUdp.Add(Frames);
floodUdp.SetAction(result => DatagramSenders.Run(result.GetValue(port), result.GetValue(Connections), result.GetValue(Frames)));

var receiver = new Argument<string>("way");
var receiverMode = new Argument<string>("mode");
var receiverPort = new Argument<int>("port");
var receiverFrames = new Argument<int>("frames");
var receive = new Command("receive", "A client of peers, in its own process.") { Hidden = true };
receive.Add(receiver);
receive.Add(receiverMode);
receive.Add(receiverPort);
receive.Add(receiverFrames);
receive.SetAction((result, _) => ManagedReceiver.RunAsync(
    result.GetValue(receiver)!, result.GetValue(receiverMode)!, result.GetValue(receiverPort), result.GetValue(receiverFrames)));

var idler = new Option<bool>("--idler");
var awake = new Command("awake", "Keeps the processors awake during broadcast.") { Hidden = true };
awake.SetAction(_ => AwakeProcessors.Run());

var sinks = new Command("sinks", "The clients of broadcast, in their own process.") { Hidden = true };
sinks.Add(port);
sinks.Add(Connections);
sinks.Add(idler);
sinks.SetAction(result => Sinks.Run(result.GetValue(port), result.GetValue(Connections), result.GetValue(idler)));

RootCommand root = Root(
    Throughput(), latency, streams, avatars, consumers, broadcast, relay, decode, bvh, kinematics, messages, retarget, recording, playback, Window(), native, micro,
    udp, start, idle, growth, peers, check, update, Flood(), Pace(), floodUdp, receive, sinks, silent, awake);
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
