using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The newest events, each in as many lines as it needs.</summary>
internal static class EventList
{
    private const int Indent = 11;

    /// <summary>Creates the lines, the oldest event first. An event without room is left out as a whole.</summary>
    public static IReadOnlyList<StyledLine> Create(EventLog log, int width, int rows)
    {
        List<StyledLine> all = [];
        foreach (LoggedEvent entry in log.Newest(rows).Reverse())
        {
            IReadOnlyList<StyledLine> lines = Wrap(entry, width);
            if (all.Count + lines.Count > rows)
                break;

            all.InsertRange(0, lines);
        }

        return all;
    }

    private static IReadOnlyList<StyledLine> Wrap(LoggedEvent entry, int width)
    {
        string text = entry.Count > 1 ? $"{entry.Count} times: {entry.Text}" : entry.Text;
        return [.. WrappedText.Break(text, Math.Max(width - Indent, 1), int.MaxValue).Select((line, index) => index == 0
            ? new StyledLine().Add($"{entry.Time:HH:mm:ss} ", Palette.DimStyle).Add("● ", new Style(entry.Color)).Add(line, Palette.DimStyle)
            : new StyledLine().Add(new string(' ', Indent)).Add(line, Palette.DimStyle))];
    }
}
