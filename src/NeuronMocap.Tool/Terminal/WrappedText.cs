using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Terminal;

/// <summary>Breaks text into lines, for views that need to know the number of lines.</summary>
internal static class WrappedText
{
    /// <summary>
    /// Breaks text between words. If there are too many lines, the first ones are left out, because the end names the setting to change.
    /// </summary>
    /// <param name="text">One line, safe for a terminal.</param>
    /// <param name="width">Width of a line in cells, at least 1.</param>
    /// <param name="most">Maximum number of lines.</param>
    public static IReadOnlyList<string> Break(string text, int width, int most)
    {
        var lines = new List<string>();
        string line = string.Empty;
        foreach (string word in text.Split(' ', StringSplitOptions.RemoveEmptyEntries).SelectMany(word => Cut(word, width)))
        {
            string longer = line.Length == 0 ? word : $"{line} {word}";
            if (line.Length > 0 && CellsOf(longer) > width)
            {
                lines.Add(line);
                line = word;
            }
            else
            {
                line = longer;
            }
        }

        if (line.Length > 0)
            lines.Add(line);
        if (lines.Count <= most)
            return lines;

        string[] end = [.. lines.TakeLast(Math.Max(most, 0))];
        if (end.Length > 0)
            end[0] = CellsOf(end[0]) < width ? $"…{end[0]}" : $"…{end[0][1..]}";

        return end;
    }

    // Breaks a word that is longer than a line, such as the name of a host.
    private static IEnumerable<string> Cut(string word, int width)
    {
        int start = 0;
        for (int i = 1; i <= word.Length; i++)
        {
            if (i == word.Length || CellsOf(word[start..(i + 1)]) > width)
            {
                yield return word[start..i];
                start = i;
            }
        }
    }

    private static int CellsOf(string text) => new Segment(text).CellCount();
}
