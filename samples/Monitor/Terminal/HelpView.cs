using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Monitor.Terminal;

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
        ("jitter", "standard deviation of the time between frames"),
        ("lost", "frames that the server counted and that did not arrive"),
        ("disordered", "frames that came twice or after a later one"),
        ("dropped", "frames that found a queue of this program full"),
        ("skipped", "bytes that belong to no packet"),
        ("ground", "the line at y = 0, with a mark every 50 cm"),
    ];

    public static IRenderable Create()
    {
        Grid grid = new Grid().AddColumn().AddColumn();
        foreach ((string name, string meaning) in Entries)
            grid.AddRow(new Text(name, Palette.StrongStyle), new Text(meaning).Ellipsis());

        return Align.Center(grid, VerticalAlignment.Middle);
    }
}
