using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch.Playback;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The keys, and the meaning of the words in the view. A small window needs several pages.</summary>
internal static class HelpView
{
    private const int WidestText = 100;
    private const int NameWidth = 14;

    private static readonly (string Name, string Meaning)[] CommonKeys =
    [
        ("q", "quit"),
        ("?", "next page of this help; esc closes it"),
    ];

    private static readonly (string Name, string Meaning)[] LiveKeys =
    [
        ("r", "start or stop a recording. It never replaces a file"),
        ("space", "freeze or resume the figures and the skeleton; frames still arrive, and a recording continues"),
    ];

    private static readonly (string Name, string Meaning)[] Rest =
    [
        ("tab", "select the next avatar"),
        ("b  B", "next or previous bones in the table, or no table"),
        ("c", "clear the counters and the scale of the drawing"),
        ("Hz", "frames per second. 30.0/2: the server sends every second frame"),
        ("jitter", "standard deviation of the time between two frames"),
        ("lost", "frames that the server sent but that did not arrive"),
        ("gaps", "runs of lost frames"),
        ("out of order", "frames that arrived twice, or after a later one. A narrow window says late"),
        ("restarts", "how often the server restarted its frame numbers"),
        ("age", "time since the newest frame arrived"),
        ("latency", "not shown: a frame does not say when it was sent, so the time in transit cannot be known"),
        ("feet", "L and R: the left or right foot is on the ground. ·: it is not. -: unknown"),
        ("dropped", "frames discarded because a queue of this program was full"),
        ("skipped", "bytes outside packets"),
        ("buffer", "datagrams that the system keeps until this program reads them. 4 MiB are asked for; 'diagnose' says how to get more"),
        ("allocates", "memory that receiving takes. The drawing runs on another thread, which is not counted"),
        ("front, side", "the drawing as seen from +Z, and from -X"),
        ("ground", "the line at y = 0, with a mark every 50 cm, and L and R below the feet that stand on it"),
    ];

    /// <summary>Creates a page.</summary>
    /// <param name="isPlayback">Whether a file is played.</param>
    /// <param name="page">Number of the page, from 0.</param>
    /// <param name="width">Available columns.</param>
    /// <param name="height">Available lines, at least 2.</param>
    public static IRenderable Create(bool isPlayback, int page, int width, int height)
    {
        IRenderable[][] pages = [.. Pages(isPlayback, Math.Min(width, WidestText), Math.Max(height - 1, 1))];
        int shown = Math.Min(page, pages.Length - 1);
        string number = pages.Length > 1 ? Quantity.Format($" ({shown + 1}/{pages.Length})") : string.Empty;
        return new Rows([new StyledLine().Add($"HELP{number}", Palette.StrongStyle), .. pages[shown]]);
    }

    /// <summary>Counts the pages.</summary>
    public static int CountPages(bool isPlayback, int width, int height) => Pages(isPlayback, Math.Min(width, WidestText), Math.Max(height - 1, 1)).Count();

    // An entry is not divided unless it is longer than a page.
    private static IEnumerable<IRenderable[]> Pages(bool isPlayback, int width, int height)
    {
        var page = new List<IRenderable>();
        foreach ((string name, string meaning) in (IEnumerable<(string, string)>)[.. CommonKeys, .. isPlayback ? PlaybackKeys.Entries : LiveKeys, .. Rest])
        {
            IReadOnlyList<StyledLine> lines = MakeEntry(name, meaning, width);
            if (page.Count > 0 && page.Count + lines.Count > height)
            {
                yield return [.. page];
                page.Clear();
            }

            page.AddRange(lines);
        }

        yield return [.. page];
    }

    private static IReadOnlyList<StyledLine> MakeEntry(string name, string meaning, int width)
    {
        int indent = width > NameWidth * 2 ? NameWidth : 2;
        IReadOnlyList<string> lines = WrappedText.Break(indent == NameWidth ? meaning : $"{name}: {meaning}", Math.Max(width - indent, 1), int.MaxValue);
        return [.. lines.Select((line, index) => new StyledLine()
            .Add(index == 0 && indent == NameWidth ? name.PadRight(indent) : new string(' ', indent), Palette.StrongStyle)
            .Add(line))];
    }
}
