using System.Globalization;
using System.Net;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.Extensions.DependencyInjection;
using NeuronMocap.AspNetCore;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Server;

namespace NeuronMocap.Benchmarks.Macro;

// A reader and a web server between a sender and WebSocket clients, which run in two other processes. One more client in the form of packets measures the
// delay from the sender. The floor is a broadcaster that relays the same frames to as many TCP clients.
internal static class Web
{
    private const double Rate = 60;
    private const string Cost = "CPU µs/frame and client";

    public static async Task<int> RunAsync(int[] counts, double seconds, int runs, Report report)
    {
        report.Begin($"A reader to WebSocket clients: {seconds} s at {Rate} Hz, {runs} runs; the floor is a relay to TCP clients.");
        foreach (int count in counts)
        {
            Way[] ways = [.. Enum.GetValues<WebSocketForm>().Select(form => new Way(form.ToString(), () => MeasureAsync(form, count, seconds)))];
            report.Add(await Alternation.RunAsync($"{count} clients", runs, new Way("TCP", () => RelayAsync(count, seconds)), ways, [new Aim("dropped %", 1)]));
        }

        return report.End();
    }

    private static async Task<Measurements> MeasureAsync(WebSocketForm form, int count, double seconds)
    {
        using Peer sender = await StartSenderAsync(seconds);
        await using NeuronReader reader = CreateReader(sender);
        await using var broadcaster = new WebSocketBroadcaster(reader);
        await using WebApplication application = Serve(broadcaster);
        await application.StartAsync();
        using Peer sinks = await Peer.StartAsync(
            "websinks", "--port", Peer.Text(new Uri(application.Urls.Single()).Port), "--connections", Peer.Text(count), "--form", form.ToString().ToLowerInvariant());
        while (broadcaster.GetStatistics().Clients <= count)
            await Task.Delay(1);

        TimeSpan cpu = await RunAsync(reader);
        string[] delays = (await sinks.ReadLineAsync()).Split(' ');
        WebSocketBroadcasterStatistics statistics = broadcaster.GetStatistics();
        double frames = statistics.FramesSent + statistics.FramesDropped + statistics.FramesMissed;
        return new Measurements
        {
            [Cost] = cpu.TotalMicroseconds / frames,
            ["median delay µs"] = double.Parse(delays[0], CultureInfo.InvariantCulture),
            ["p99 delay µs"] = double.Parse(delays[1], CultureInfo.InvariantCulture),
            ["dropped %"] = 100 * (statistics.FramesDropped + statistics.FramesMissed) / frames,
        };
    }

    private static async Task<Measurements> RelayAsync(int count, double seconds)
    {
        using Peer sender = await StartSenderAsync(seconds);
        await using NeuronReader reader = CreateReader(sender);
        using var relay = new Broadcaster(new BroadcasterOptions { Reader = reader, Port = 0, CloseTimeout = TimeSpan.FromSeconds(1) });
        relay.Start();
        using Peer sinks = await Peer.StartAsync("sinks", "--port", Peer.Text(relay.LocalEndPoint!.Port), "--connections", Peer.Text(count), "--idler", "false");
        while (relay.GetStatistics().Clients < count)
            await Task.Delay(1);

        TimeSpan cpu = await RunAsync(reader);
        await sinks.ReadLineAsync();
        return new Measurements { [Cost] = cpu.TotalMicroseconds / relay.GetStatistics().FramesSent };
    }

    private static WebApplication Serve(WebSocketBroadcaster broadcaster)
    {
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.WebHost.UseKestrelCore().ConfigureKestrel(static kestrel => kestrel.Listen(IPAddress.Loopback, 0));
        builder.Services.AddRoutingCore();
        WebApplication application = builder.Build();
        application.MapNeuronWebSocket("/", broadcaster);
        return application;
    }

    private static Task<Peer> StartSenderAsync(double seconds) =>
        Peer.StartAsync("pace", "--connections", "1", "--rate", Peer.Text(Rate), "--seconds", Peer.Text(seconds));

    private static NeuronReader CreateReader(Peer sender) => new(new NeuronReaderOptions { Port = sender.Port, Reconnect = { Enabled = false } });

    // Returns the time of all processors.
    private static async Task<TimeSpan> RunAsync(NeuronReader reader)
    {
        TimeSpan before = RuntimeFigures.CpuTime;
        reader.Start();
        await reader.Completion;
        return RuntimeFigures.CpuTime - before;
    }
}
