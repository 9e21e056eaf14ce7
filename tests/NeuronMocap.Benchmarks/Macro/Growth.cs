using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;

namespace NeuronMocap.Benchmarks.Macro;

// The cost of a frame as a number grows. The floor is the smallest number, so a ratio of 1 means that the total grows with the number and not faster.
internal static class Growth
{
    public const string Cost = "CPU ns/frame";
    private const string Lost = "lost";
    private const int Takes = 400_000;

    // Two processors can serve 1,000 clients at this rate.
    private const double RateOfClients = 20;
    private const int WarmFrames = 80;

    public static async Task<int> RunAsync(int[] counts, double[] hours, FileInfo? tool, double seconds, int runs, Report report)
    {
        report.Begin($"Cost of a frame for each connection, avatar, consumer or client, {runs} runs of {seconds} s; the floor is the smallest number.");

        // At these rates, the depth of the processors' sleep would decide what a frame costs.
        using (OperatingSystem.IsLinux() ? await Peer.StartAsync("awake") : null)
        {
            await AddAsync("connections", async count => Pick(await Streams.MeasureAsync(count, seconds), Streams.Cost));
            await AddAsync("clients", async count => Pick(await Broadcast.PacedAsync(count, seconds, withIdler: false, RateOfClients, WarmFrames), Broadcast.Cost));
        }

        await AddAsync("avatars", static count => Task.FromResult(Pick(Scaling.Measure(count, 1, newest: false))));
        await AddAsync("consumers", static count => Task.FromResult(Pick(Scaling.Measure(1, count, newest: false, Math.Max(4000, Takes / count)))));
        await GrowthOfRecordings.RunAsync(hours, tool, runs, report);
        return report.End();

        async Task AddAsync(string what, Func<int, Task<Measurements>> measure)
        {
            Way[] ways = [.. counts.Order().Select(count => new Way(Peer.Text(count), () => measure(count)))];
            report.Add(await Alternation.RunAsync(what, runs, ways[0], ways[1..], [new Aim(Cost, 1.2, IsRatio: true), new Aim(Lost, 0)]));
        }
    }

    private static Measurements Pick(Measurements figures, string microseconds) => new() { [Cost] = figures[microseconds] * 1000, [Lost] = figures[Lost] };

    // It throws if a frame is lost.
    private static Measurements Pick(Measurements figures) => new() { [Cost] = figures[Check.Cpu] };
}
