using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using static NeuronMocap.Benchmarks.Macro.Native;

namespace NeuronMocap.Benchmarks.Macro;

// The same stream through other clients, each in a process of its own: a blocking receive in C, which is the floor, a client as tutorials write it, and the
// library.
internal sealed class Clients(FileInfo raw, int runs, Report report)
{
    private static readonly string[] Names = ["library", "BinaryReader"];

    public async Task<int> RunAsync(int frames, int[] writes, double[] rates, double seconds)
    {
        report.Begin($"{frames} frames of {TestFrame.Size} bytes over loopback TCP to several clients, then one frame at a time for {seconds} s, {runs} runs; the floor is a blocking receive in C.");
        foreach (int perWrite in writes)
            await CompareAsync($"{perWrite} frames/write", start => FloodAsync(start, "throughput", perWrite, frames));

        foreach (double rate in rates)
            await CompareAsync($"{rate} Hz", start => PaceAsync(start, rate, seconds));

        return report.End();
    }

    private async Task CompareAsync(string @case, Func<Starter, Task<Measurements>> measure)
    {
        Way[] ways = [.. Names.Select(name => new Way(name, () => measure((mode, port, frames) =>
            NativeReceiver.Start("dotnet", "exec", typeof(Clients).Assembly.Location, "receive", name, mode, Peer.Text(port), Peer.Text(frames)))))];
        Way floor = new("recv in C", () => measure((mode, port, frames) => NativeReceiver.Start(raw, mode, port, frames)));
        report.Add(await Alternation.RunAsync(@case, runs, floor, ways, []));
    }
}
