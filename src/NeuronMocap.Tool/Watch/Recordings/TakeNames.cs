using System.Globalization;

namespace NeuronMocap.Tool.Watch.Recordings;

/// <summary>The names of the files that the key of the live view begins.</summary>
internal static class TakeNames
{
    /// <summary>Names to try in turn, until one is free: take.nmrec, take-2.nmrec and so on.</summary>
    /// <param name="path">What --record says. Null makes a name of the date and time, in the current folder.</param>
    /// <param name="now">The time of this computer.</param>
    public static IEnumerable<string> After(string? path, DateTime now)
    {
        string first = path ?? now.ToString("'neuron-'yyyy-MM-dd-HHmmss'.nmrec'", CultureInfo.InvariantCulture);
        yield return first;

        string extension = Path.GetExtension(first);
        string start = first[..^extension.Length];
        for (int number = 2; ; number++)
            yield return string.Create(CultureInfo.InvariantCulture, $"{start}-{number}{extension}");
    }
}
