using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch.Playback;
using Spectre.Console;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The keys, on the line at the bottom. A narrow window shows the most important ones.</summary>
internal static class Footer
{
    private const string Gap = "  ";
    private const string Legend = " ■ left ■ right";
    private const int LegendFrom = 80;

    public static StyledLine Create(LiveState state, int width)
    {
        var line = new StyledLine();
        int limit = width < LegendFrom ? width : width - Legend.Length;
        int used = 0;
        foreach ((string key, string action) in KeysOf(state))
        {
            string gap = used == 0 ? string.Empty : Gap;
            int length = gap.Length + key.Length + 1 + action.Length;
            if (used + length > limit)
                continue;

            line.Add(gap).Add(key, Palette.StrongStyle).Add($" {action}", Palette.DimStyle);
            used += length;
        }

        return width < LegendFrom ? line : line.AddColouredRight("■ left ", new Style(Palette.Left)).AddColouredRight("■ right", new Style(Palette.Right));
    }

    // The most important first.
    private static IEnumerable<(string Key, string Action)> KeysOf(LiveState state)
    {
        if (!state.HasKeyboard)
            return [("Ctrl-C", "quits; standard input is not a keyboard")];
        if (state.HelpPage is not null)
            return [("?", "next page"), ("esc", "close"), ("q", "quit")];

        (string, string)[] pause = state.Player is null ? [("space", state.IsPaused ? "resume" : "freeze")] : PlaybackKeys.Hints(state.Player.IsPaused);
        (string, string)[] record = state.Player is null ? [("r", state.Takes?.Current is null ? "record" : "stop")] : [];
        return [("q", "quit"), ("?", "help"), .. record, .. pause, ("tab", "avatar"), ("b", "bones"), ("c", "clear")];
    }
}
