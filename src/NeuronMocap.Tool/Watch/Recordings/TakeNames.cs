using System.Globalization;

namespace NeuronMocap.Tool.Watch.Recordings;

/// <summary>The names of files that the recording key of the live view creates.</summary>
internal static class TakeNames
{
    /// <summary>Gets names to try in turn until one is free: take.nmrec, take-2.nmrec and so on.</summary>
    /// <param name="path">The path of --record. Null uses the date and time, in the folder.</param>
    /// <param name="now">The time of this computer.</param>
    /// <param name="folder">The folder for a name of date and time; empty for the current one.</param>
    public static IEnumerable<string> After(string? path, DateTime now, string folder = "")
    {
        string first = path ?? Path.Combine(folder, NameOf(now));
        yield return first;

        string extension = Path.GetExtension(first);
        string start = first[..^extension.Length];
        for (int number = 2; ; number++)
            yield return string.Create(CultureInfo.InvariantCulture, $"{start}-{number}{extension}");
    }

    private static string NameOf(DateTime now) => now.ToString("'neuron-'yyyy-MM-dd-HHmmss'.nmrec'", CultureInfo.InvariantCulture);
}
