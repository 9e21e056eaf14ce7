using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Monitor.Terminal;

/// <summary>A row for each stream of each avatar, and a line of what the reader counts in all.</summary>
internal static class AvatarTable
{
    /// <summary>Lines besides the rows of avatars: head and totals.</summary>
    public const int FixedHeight = 2;

    private static readonly TimeSpan Stale = TimeSpan.FromSeconds(1);

    /// <summary>Makes the table.</summary>
    /// <param name="state">What to show.</param>
    /// <param name="rows">Room for avatars; the last one tells how many are left out, when there are more.</param>
    public static IRenderable Create(LiveState state, int rows)
    {
        IReadOnlyList<AvatarStatistics> avatars = state.Counters.Avatars;
        int shown = avatars.Count <= rows ? avatars.Count : Math.Max(rows - 1, 0);
        Table table = new Table().Border(TableBorder.None).Expand();
        foreach (string title in (string[])["avatar", "stream", "Hz", "jitter", "frames", "lost", "disordered", "age", "feet"])
            table.AddColumn(new TableColumn(new Text(title, Palette.DimStyle)) { NoWrap = true, Alignment = IsText(title) ? Justify.Left : Justify.Right });

        // The selected avatar and those that are named first stay in sight; the rest is a number.
        foreach (AvatarStatistics avatar in avatars.OrderBy(avatar => (uint)avatar.AvatarIndex).ThenBy(avatar => avatar.Kind).Take(shown))
            table.AddRow(MakeRow(state, avatar));
        if (shown < avatars.Count)
            table.AddRow(new Text(Quantity.Format($"  and {avatars.Count - shown} more"), Palette.DimStyle));
        else if (avatars.Count == 0)
            table.AddRow(new Text("  none yet", Palette.DimStyle));

        return new Rows(table, Totals(state));
    }

    public static int CountRows(LiveState state) => Math.Max(state.Counters.Avatars.Count, 1);

    private static bool IsText(string title) => title is "avatar" or "stream" or "feet";

    private static IRenderable[] MakeRow(LiveState state, AvatarStatistics avatar)
    {
        bool isMotion = avatar.Kind == PacketKind.Motion;
        bool isSelected = isMotion && avatar.AvatarIndex == state.Avatar;
        TimeSpan age = Stopwatch.GetElapsedTime(avatar.LastTimestamp, Math.Max(state.Now, avatar.LastTimestamp));
        bool isStale = age > Stale;
        string sender = avatar.Source > 0 ? Quantity.Format($" (sender {avatar.Source})") : string.Empty;
        return
        [
            new Text($"{(isSelected ? '>' : ' ')} {(uint)avatar.AvatarIndex} {TerminalText.Clean(avatar.AvatarName)}{sender}", isSelected ? Palette.StrongStyle : Style.Plain).Ellipsis(),
            new Text(isMotion ? "motion" : "calculation"),
            isStale ? new Text("0", new Style(Palette.Bad)) : new Text(Quantity.Fixed(avatar.Rate, 1)),
            new Text(isStale ? "-" : Quantity.Format($"{avatar.Jitter.TotalMilliseconds:0.0} ms")),
            new Text(Quantity.Count(avatar.Frames)),
            Alarm(avatar.Lost),
            Alarm(avatar.Disordered),
            new Text(Quantity.Duration(age), isStale ? new Style(Palette.Bad) : Style.Plain),
            isMotion ? Text.Empty : Feet(state.GetContacts(avatar.AvatarIndex)),
        ];
    }

    private static Text Alarm(long count) => new(Quantity.Count(count), count > 0 ? new Style(Palette.Warning) : Style.Plain);

    private static Paragraph Feet((bool Left, bool Right)? contacts)
    {
        if (contacts is not { } feet)
            return new Paragraph("-");

        return new Paragraph()
            .Append("L", feet.Left ? new Style(Color.Black, Palette.Left) : Palette.DimStyle)
            .Append(" ")
            .Append("R", feet.Right ? new Style(Color.Black, Palette.Right) : Palette.DimStyle);
    }

    private static StyledLine Totals(LiveState state)
    {
        ReaderStatistics total = state.Counters.Total;
        return new StyledLine()
            .Add($"dropped {Quantity.Count(total.Dropped)}", total.Dropped > 0 ? new Style(Palette.Warning) : Palette.DimStyle)
            .Add(" · ", Palette.DimStyle)
            .Add($"skipped {Quantity.Bytes(total.SkippedBytes)}", total.SkippedBytes > 0 ? new Style(Palette.Warning) : Palette.DimStyle)
            .Add(" · ", Palette.DimStyle)
            .Add($"{Quantity.Bytes(state.BytesPerSecond)}/s")
            .AddRight($"this program: {Quantity.Bytes(state.AllocatedBytesPerSecond)}/s allocated, {state.Collections} GCs", Palette.DimStyle);
    }
}
