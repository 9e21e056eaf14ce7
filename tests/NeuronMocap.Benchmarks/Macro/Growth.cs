using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;

namespace NeuronMocap.Benchmarks.Macro;

// The cost of a frame as a number grows. The floor is the smallest number, so a ratio of 1 means that the total grows with the number and not faster.
internal static class Growth
{
    public const string Cost = "CPU ns/frame";
    private const int Takes = 400_000;

    public static async Task<int> RunAsync(int[] counts, double[] hours, FileInfo? tool, double seconds, int runs, Report report)
    {
        report.Begin($"Cost of a frame for each connection, avatar, consumer or client, {runs} runs of {seconds} s; the floor is the smallest number.");

        // A single connection would otherwise cost the wake of a processor, which many of them share.
        using (OperatingSystem.IsLinux() ? await Peer.StartAsync("awake") : null)
        {
            await AddAsync("connections", async count => (await Streams.MeasureAsync(count, seconds))[Streams.Cost] * 1000);
            await AddAsync("clients", async count => (await Broadcast.PacedAsync(count, seconds, withIdler: false))[Broadcast.Cost] * 1000);
        }

        await AddAsync("avatars", static count => Task.FromResult(Scaling.Measure(count, 1, newest: false)[Check.Cpu]));
        await AddAsync("consumers", static count => Task.FromResult(Scaling.Measure(1, count, newest: false, Math.Max(4000, Takes / count))[Check.Cpu]));
        await GrowthOfRecordings.RunAsync(hours, tool, runs, report);
        return report.End();

        async Task AddAsync(string what, Func<int, Task<double>> measure)
        {
            Way[] ways = [.. counts.Order().Select(count => new Way(Peer.Text(count), async () => new Measurements { [Cost] = await measure(count) }))];
            report.Add(await Alternation.RunAsync(what, runs, ways[0], ways[1..], [new Aim(Cost, 1.2, IsRatio: true)]));
        }
    }
}
