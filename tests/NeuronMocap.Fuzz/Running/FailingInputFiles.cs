using System.Globalization;

namespace NeuronMocap.Fuzz.Running;

/// <summary>Writes what was found where somebody can work on it: the smallest input, and a text that says what happened.</summary>
internal static class FindingFiles
{
    /// <summary>Writes both files.</summary>
    /// <returns>Path of the input.</returns>
    public static string Write(FuzzFinding finding, ulong seed, string folder)
    {
        Directory.CreateDirectory(folder);
        string name = string.Create(CultureInfo.InvariantCulture, $"{finding.Target}-{seed}-{(finding.Number < 0 ? "kept" : "")}{Math.Abs(finding.Number)}");
        string path = Path.Combine(folder, name + ".bin");
        File.WriteAllBytes(path, finding.Smallest);
        File.WriteAllBytes(Path.Combine(folder, name + ".original"), finding.Original);
        File.WriteAllText(Path.Combine(folder, name + ".txt"), Describe(finding, seed, path));
        return path;
    }

    private static string Describe(FuzzFinding finding, ulong seed, string path) => string.Create(CultureInfo.InvariantCulture, $"""
        target   {finding.Target}
        seed     {seed}
        input    number {finding.Number}, {finding.Original.Length} bytes; {finding.Smallest.Length} are enough
        failure  {finding.Failure.Kind}
        again    dotnet run --project tests/NeuronMocap.Fuzz -- --target {finding.Target} --replay "{path}"
        keep     cp "{path}" tests/NeuronMocap.Fuzz/corpus/{finding.Target}-what-is-wrong.bin

        {finding.Failure.Description}

        """);
}
