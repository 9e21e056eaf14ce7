using NeuronMocap.Benchmarks.Harness;

namespace NeuronMocap.Benchmarks.Page;

// Writes results into the page, and the curves beside it.
internal static class PageUpdate
{
    private const string Growth = "net8.0-growth";

    public static int Run(DirectoryInfo results, FileInfo page)
    {
        string text = File.ReadAllText(page.FullName);
        if (Read(Growth) is { } growth)
            File.WriteAllText(Path.Combine(page.DirectoryName!, PageTables.GrowthPicture), GrowthChart.Draw(growth, Macro.Check.Cpu));

        File.WriteAllText(page.FullName, PageTables.Update(text, Read));
        return 0;

        Results? Read(string name) => Path.Combine(results.FullName, name + ".json") is var path && File.Exists(path) ? Report.Read(path) : null;
    }
}
