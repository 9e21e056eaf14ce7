using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using static NeuronMocap.Benchmarks.Macro.Native;

namespace NeuronMocap.Benchmarks.Macro;

// The same stream through other clients, each in a process of its own: a blocking receive in C, which is the floor, a client as tutorials write it, and the
// library.
internal sealed class Clients(FileInfo raw, int runs, Report report)
{
    private const int MostTimes = 8;

    // A client that makes a system call for each value gets a part of the frames only, so that it does not need minutes.
    private static readonly (string Name, int Part)[] Others = [("library", 1), ("BinaryReader", 20)];

    public async Task<int> RunAsync(int frames, int[] writes, double[] rates, double seconds)
    {
        report.Begin($"{frames} frames of {TestFrame.Size} bytes over loopback TCP to several clients, then one frame at a time for {seconds} s, {runs} runs; the floor is a blocking receive in C.");
        foreach (int perWrite in writes)
        {
            // More of the frames that take less time, so that .NET compiles the library in a small part of the run only.
            int whole = frames * Math.Min(perWrite, MostTimes);
            await CompareAsync($"{perWrite} frames/write", (start, part) => FloodAsync(start, "throughput", perWrite, part == 1 ? whole : frames / part));
        }

        foreach (double rate in rates)
            await CompareAsync($"{rate} Hz", (start, _) => PaceAsync(start, rate, seconds));

        return report.End();
    }

    private async Task CompareAsync(string @case, Func<Starter, int, Task<Measurements>> measure)
    {
        Way[] ways = [.. Others.Select(other => new Way(other.Name, () => measure(From(other.Name), other.Part)))];
        Way floor = new("recv in C", () => measure((mode, port, frames) => NativeReceiver.Start(raw, mode, port, frames), 1));
        report.Add(await Alternation.RunAsync(@case, runs, floor, ways, []));
    }

    private static Starter From(string name) => (mode, port, frames) =>
        NativeReceiver.Start("dotnet", "exec", typeof(Clients).Assembly.Location, "receive", name, mode, Peer.Text(port), Peer.Text(frames));
}
