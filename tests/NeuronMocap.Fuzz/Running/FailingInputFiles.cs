using System.Globalization;

namespace NeuronMocap.Fuzz.Running;

/// <summary>Writes findings for later analysis: the smallest input, and a text that describes what happened.</summary>
internal static class FailingInputFiles
{
    /// <summary>Writes both files.</summary>
    /// <returns>The path of the input.</returns>
    public static string Write(FailingInput failing, ulong seed, string folder)
    {
        Directory.CreateDirectory(folder);
        string name = string.Create(CultureInfo.InvariantCulture, $"{failing.Target}-{seed}-{(failing.Number < 0 ? "kept" : "")}{Math.Abs(failing.Number)}");
        string path = Path.Combine(folder, name + ".bin");
        File.WriteAllBytes(path, failing.Smallest);
        File.WriteAllBytes(Path.Combine(folder, name + ".original"), failing.Original);
        File.WriteAllText(Path.Combine(folder, name + ".txt"), Describe(failing, seed, path));
        return path;
    }

    private static string Describe(FailingInput failing, ulong seed, string path) => string.Create(CultureInfo.InvariantCulture, $"""
        target   {failing.Target}
        seed     {seed}
        input    number {failing.Number}, {failing.Original.Length} bytes; {failing.Smallest.Length} are enough
        failure  {failing.Failure.Kind}
        again    dotnet run --project tests/NeuronMocap.Fuzz -- --target {failing.Target} --replay "{path}"
        keep     cp "{path}" tests/NeuronMocap.Fuzz/corpus/{failing.Target}-what-is-wrong.bin

        {failing.Failure.Description}

        """);
}
