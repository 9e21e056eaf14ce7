using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;

namespace NeuronMocap.Benchmarks.Macro;

// What connections cost that deliver nothing. The runtime wakes up a little by itself, so the floor is the same process without a connection.
internal static class Idle
{
    private const string Rate = "wake-ups/s";
    private const string Share = "% of a core";

    private static readonly Aim[] Aims = [new(Rate, 1), new(Share, 0.1)];

    // settle: seconds after which the readers are silent and the pool has ended the threads that it no longer needs.
    public static async Task<int> RunAsync(int[] counts, double settle, double seconds, int runs, Report report)
    {
        report.Begin($"Silent connections in one process, {seconds} s a run after {settle} s, {runs} runs; the floor has no connection.");
        Way[] ways = [.. counts.Select(count => new Way(count == 1 ? "1 connection" : $"{count} connections", () => MeasureAsync(count, settle, seconds)))];
        report.Add(await Alternation.RunAsync("silent", runs, new Way("none", () => MeasureAsync(0, settle, seconds)), ways, Aims));
        return report.End();
    }

    private static async Task<Measurements> MeasureAsync(int count, double settle, double seconds)
    {
        using Peer server = await Peer.StartAsync("silent", "--connections", Peer.Text(count));
        NeuronReader[] readers = [.. Enumerable.Range(0, count)
            .Select(_ => new NeuronReader(new NeuronReaderOptions { Port = server.Port, Reconnect = { Enabled = false } }))];
        await Task.WhenAll(readers.Select(static reader => reader.StartAsync()));

        // A thread of its own, because a wait on the pool would wake several.
        Measurements figures = await Task.Factory.StartNew(() => Measure(settle, seconds), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        server.CloseInput();
        foreach (NeuronReader reader in readers)
            await reader.DisposeAsync();

        return figures;
    }

    private static Measurements Measure(double settle, double seconds)
    {
        Thread.Sleep(TimeSpan.FromSeconds(settle));
        Dictionary<string, long> before = WakeUps.Read();
        TimeSpan cpu = Environment.CpuUsage.TotalTime;
        Thread.Sleep(TimeSpan.FromSeconds(seconds));
        cpu = Environment.CpuUsage.TotalTime - cpu;
        Dictionary<string, long> after = WakeUps.Read();

        // Without the wake-up of this thread.
        return new Measurements { [Rate] = Math.Max(0, WakeUps.Between(before, after) - 1) / seconds, [Share] = cpu.TotalSeconds / seconds * 100 };
    }
}
