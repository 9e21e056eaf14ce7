using System.Globalization;

namespace NeuronMocap.Benchmarks.Harness;

// How often the threads of this process went to sleep so far, as Linux counts it. Each sleep has one wake-up.
internal static class WakeUps
{
    private const string Name = "voluntary_ctxt_switches:";

    public static Dictionary<string, long> Read()
    {
        Dictionary<string, long> counts = [];
        foreach (string thread in Directory.EnumerateDirectories("/proc/self/task"))
        {
            try
            {
                string line = File.ReadLines(Path.Combine(thread, "status")).First(static line => line.StartsWith(Name, StringComparison.Ordinal));
                counts[$"{Path.GetFileName(thread)} {File.ReadAllText(Path.Combine(thread, "comm")).Trim()}"] = long.Parse(line[Name.Length..], CultureInfo.InvariantCulture);
            }
            catch (IOException)
            {
                // The thread has ended.
            }
        }

        return counts;
    }

    public static long Between(Dictionary<string, long> before, Dictionary<string, long> after) =>
        after.Sum(thread => thread.Value - before.GetValueOrDefault(thread.Key));
}
