using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Macro;

namespace NeuronMocap.Benchmarks.Page;

// Writes results into the page, and the curves beside it.
internal static class PageUpdate
{
    private const string GrowthResults = "net8.0-growth";

    public static int Run(DirectoryInfo results, FileInfo page)
    {
        string text = File.ReadAllText(page.FullName);
        if (Read(GrowthResults) is { } growth)
        {
            Write(PageTables.GrowthPicture, GrowthChart.DrawCounts(growth, Growth.Cost));
            Write(PageTables.RecordingsPicture, GrowthChart.DrawRecordings(growth, GrowthOfRecordings.Case));
        }

        File.WriteAllText(page.FullName, PageTables.Update(text, Read));
        return 0;

        void Write(string picture, string svg) => File.WriteAllText(Path.Combine(page.DirectoryName!, picture), svg);

        Results? Read(string name) => Path.Combine(results.FullName, name + ".json") is var path && File.Exists(path) ? Report.Read(path) : null;
    }
}
