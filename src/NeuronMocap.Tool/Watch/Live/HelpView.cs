using NeuronMocap.Tool.Play;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The keys, and what the words of the view mean.</summary>
internal static class HelpView
{
    private static readonly (string Name, string Meaning)[] Entries =
    [
        ("q", "quit"),
        ("space", "pause the figures and the skeleton; frames still arrive"),
        ("r", "reset the counters and the scale of the drawing"),
        ("tab", "draw the next avatar"),
        ("b", "next bones in the table"),
        ("Hz", "frames per second; 30.0/2: the server sends every second frame (frequency reducing)"),
        ("jitter", "standard deviation of the time between frames"),
        ("lost, gaps", "frames that the server sent and that did not arrive, and rows of them"),
        ("disordered", "frames that came twice or after a later one"),
        ("restarts", "times that the server began to count frames anew"),
        ("age", "time since the newest frame"),
        ("dropped", "frames that found a queue of this program full"),
        ("skipped", "bytes that belong to no packet"),
        ("feet", "L, R: this foot stands on the ground; a dot: it does not; -: not known"),
        ("ground", "the line at y = 0, with a mark every 50 cm"),
    ];

    public static IRenderable Create(bool isPlayback)
    {
        Grid grid = new Grid().AddColumn().AddColumn();
        (string Name, string Meaning)[] entries = isPlayback ? [.. PlaybackKeys.Entries, .. Entries.Where(static entry => !entry.Name.Equals("space", StringComparison.Ordinal))] : Entries;
        foreach ((string name, string meaning) in entries)
            grid.AddRow(new Text(name, Palette.StrongStyle), new Text(meaning).Ellipsis());

        return Align.Center(grid, VerticalAlignment.Middle);
    }
}
