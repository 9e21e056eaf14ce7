using NeuronMocap.Tool.Terminal;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>A table with a row for each stream of each avatar, and the totals of the reader.</summary>
internal static class AvatarTable
{
    private const int HeadHeight = 1;
    private const int BorderHeight = 2;
    private const int Gap = 1;
    private const int Small = 72;
    private const int Usual = 80;
    private const int Wide = 95;
    private const int Widest = 120;
    private const int WidestName = 40;
    private const string Lifted = "·";

    // The widths are fixed, so that the table does not move while its numbers change. A narrow window shows only the essential columns.
    private static readonly Column[] Columns =
    [
        new("stream", 6, 12, Justify.Left),
        new("Hz", 6, 8, Justify.Right),
        new("jitter", 8, 10, Justify.Right, From: Small),
        new("frames", 10, 12, Justify.Right),
        new("lost", 6, 8, Justify.Right),
        new("gaps", 6, 6, Justify.Right, From: Widest),
        new("out of order", 6, 14, Justify.Right, From: Usual, Short: "late"),
        new("restarts", 8, 8, Justify.Right, From: Widest),
        new("age", 7, 7, Justify.Right),
        new("feet", 4, 4, Justify.Left),
    ];

    private static readonly TimeSpan Stale = TimeSpan.FromSeconds(1);

    /// <summary>Gets the height of the table in lines.</summary>
    /// <param name="state">The state to show.</param>
    /// <param name="width">Columns of the window.</param>
    /// <param name="rows">Maximum number of rows for avatars.</param>
    /// <param name="framed">Whether the table has a border.</param>
    public static int HeightOf(LiveState state, int width, int rows, bool framed) =>
        Math.Min(Math.Max(state.Counters.Avatars.Count, 1), rows) + (width < Dashboard.TableWidth ? 0 : HeadHeight) + (framed ? BorderHeight : 0);

    /// <summary>Creates the table. A narrow window has no columns, and one line for each stream.</summary>
    /// <param name="state">The state to show.</param>
    /// <param name="rows">Room for avatars. If there are more, the last row gives the number of the rest.</param>
    /// <param name="width">Available columns.</param>
    public static IRenderable Create(LiveState state, int rows, int width)
    {
        IReadOnlyList<AvatarStatistics> avatars = state.Counters.Avatars;
        int shown = avatars.Count <= rows ? avatars.Count : Math.Max(rows - 1, 0);
        AvatarStatistics[] first = [.. WithSelected(state, [.. avatars.OrderBy(static avatar => (uint)avatar.AvatarIndex).ThenBy(static avatar => avatar.Kind)], shown)];
        StyledLine? rest = shown < avatars.Count ? new StyledLine().Add(Quantity.Format($"  and {avatars.Count - shown} more"), Palette.DimStyle)
            : avatars.Count == 0 ? new StyledLine().Add("  no avatars yet", Palette.DimStyle)
            : null;
        return width < Dashboard.TableWidth
            ? new Rows([.. first.Select(avatar => MakeLine(state, avatar)), .. rest is null ? Array.Empty<IRenderable>() : [rest]])
            : MakeTable(state, first, rest, width);
    }

    /// <summary>Creates the totals of the reader.</summary>
    public static IReadOnlyList<StyledLine> Totals(LiveState state, int width)
    {
        ReaderStatistics total = state.Counters.Total;
        return Piece.Flow(
            [
                new Piece($"dropped {Quantity.Count(total.Dropped)}", total.Dropped > 0 ? Palette.WarningStyle : Palette.DimStyle),
                new Piece($"skipped {Quantity.Bytes(total.BytesSkipped)}", total.BytesSkipped > 0 ? Palette.WarningStyle : Palette.DimStyle),
                .. total.RejectedMessages > 0 ? [new Piece($"rejected {Quantity.Count(total.RejectedMessages, "message")}", Palette.WarningStyle)] : Array.Empty<Piece>(),
                new Piece($"{Quantity.Bytes(state.BytesPerSecond)}/s"),
            ],
            [
                new Piece($"receiving allocates {Quantity.Bytes(state.BytesAllocatedByReceiving)}/s", Palette.DimStyle),
            ],
            " · ",
            width);
    }

    // Takes rows from the start, unless they would not include the selected avatar.
    private static IEnumerable<AvatarStatistics> WithSelected(LiveState state, AvatarStatistics[] avatars, int shown)
    {
        int selected = Array.FindIndex(avatars, avatar => IsSelected(state, avatar));
        return avatars.Skip(Math.Max(selected - shown + 1, 0)).Take(shown);
    }

    private static Table MakeTable(LiveState state, AvatarStatistics[] avatars, StyledLine? rest, int width)
    {
        bool isWide = width >= Wide;
        Column[] columns = [.. Columns.Where(column => width >= column.From)];
        Table table = new Table().Border(TableBorder.None);
        int nameWidth = Math.Min(width - Gap - columns.Sum(column => Gap + column.WidthWhen(isWide)), WidestName);
        table.AddColumn(MakeColumn("avatar", nameWidth, Justify.Left));
        foreach (Column column in columns)
            table.AddColumn(MakeColumn(column.TitleWhen(isWide), column.WidthWhen(isWide), column.Alignment));

        foreach (AvatarStatistics avatar in avatars)
            table.AddRow(MakeRow(state, avatar, width));
        if (rest is not null)
            table.AddRow(rest);

        return table;
    }

    // Example: "> 0 Demo          60.0 Hz  lost 0  L R"
    private static StyledLine MakeLine(LiveState state, AvatarStatistics avatar)
    {
        bool isStale = avatar.GetAge(state.TakenAt) > Stale;
        string kind = avatar.Kind == PacketKind.Motion ? string.Empty : $" {NameOf(avatar.Kind, isWide: false)}";
        return new StyledLine()
            .Add(NameOf(state, avatar) + kind, IsSelected(state, avatar) ? Palette.StrongStyle : Style.Plain)
            .AddRight(isStale ? $"no data for {Quantity.Age(avatar.GetAge(state.TakenAt))}" : $"{DescribeRate(avatar)} Hz", isStale ? new Style(Palette.Bad) : Style.Plain)
            .AddRight($"  lost {Quantity.Count(avatar.Lost)}", avatar.Lost > 0 ? Palette.WarningStyle : Style.Plain)
            .AddRight("  ")
            .AddRight(FeetOf(state, avatar));
    }

    private static TableColumn MakeColumn(string title, int width, Justify alignment) => new(new Text(title, Palette.DimStyle))
    {
        NoWrap = true,
        Width = width,
        Alignment = alignment,
        Padding = new Padding(0, 0, Gap, 0),
    };

    private static IEnumerable<IRenderable> MakeRow(LiveState state, AvatarStatistics avatar, int width) =>
    [
        MakeName(state, avatar),
        .. MakeCells(state, avatar, width >= Wide).Zip(Columns).Where(pair => width >= pair.Second.From).Select(pair => pair.First),
    ];

    private static StyledLine MakeName(LiveState state, AvatarStatistics avatar) =>
        new StyledLine().Add(NameOf(state, avatar), IsSelected(state, avatar) ? Palette.StrongStyle : Style.Plain);

    private static bool IsSelected(LiveState state, AvatarStatistics avatar) =>
        avatar.Kind == PacketKind.Motion && avatar.AvatarIndex == state.Selected?.Avatar;

    private static string NameOf(LiveState state, AvatarStatistics avatar)
    {
        string sender = avatar.Sender > 0 ? Quantity.Format($" (sender {avatar.Sender})") : string.Empty;
        return Quantity.Format($"{(IsSelected(state, avatar) ? '>' : ' ')} {(uint)avatar.AvatarIndex} {avatar.AvatarName}{sender}");
    }

    // One cell for each column.
    private static IRenderable[] MakeCells(LiveState state, AvatarStatistics avatar, bool isWide)
    {
        TimeSpan age = avatar.GetAge(state.TakenAt);
        bool isStale = age > Stale;
        return
        [
            new Text(NameOf(avatar.Kind, isWide)),
            isStale ? new Text("0", new Style(Palette.Bad)) : new Text(DescribeRate(avatar)),
            new Text(isStale ? "-" : Quantity.Format($"{avatar.Jitter.TotalMilliseconds:0.0} ms")),
            new Text(Quantity.Count(avatar.Frames)),
            Alarm(avatar.Lost),
            Alarm(avatar.Gaps),
            Alarm(avatar.OutOfOrder),
            new Text(Quantity.Count(avatar.Restarts)),
            new Text(Quantity.Age(age), isStale ? new Style(Palette.Bad) : Style.Plain),
            new StyledLine().Add(FeetOf(state, avatar)),
        ];
    }

    private static string NameOf(PacketKind kind, bool isWide) => kind switch
    {
        PacketKind.Motion => "motion",
        PacketKind.Calculation => isWide ? "calculation" : "calc",
        _ => isWide ? "studio calc" : "stud",
    };

    // Example: "30.0/2" for every second frame.
    private static string DescribeRate(AvatarStatistics avatar) =>
        Quantity.Fixed(avatar.FrameRate, 1) + (avatar.FrequencyReduction > 1 ? Quantity.Format($"/{avatar.FrequencyReduction}") : string.Empty);

    private static Text Alarm(long count) => new(Quantity.Count(count), count > 0 ? new Style(Palette.Warning) : Style.Plain);

    // Calculation data contains the contacts. For motion data they are estimated.
    private static Piece FeetOf(LiveState state, AvatarStatistics avatar) => avatar.Kind switch
    {
        PacketKind.Calculation => Feet(state.GetContacts(avatar.AvatarIndex)),
        PacketKind.Motion => Feet(state.Views.FirstOrDefault(view => view.Avatar == avatar.AvatarIndex)?.Contacts),
        _ => new Piece("   "),
    };

    private static Piece Feet(FootContacts? contacts)
    {
        if (contacts is not { } feet)
            return new Piece("-  ");

        // Uses letters in addition to colours. NO_COLOR switches colours off, and not everyone can distinguish them.
        return new Piece(feet.Left ? "L" : Lifted, feet.Left ? new Style(Color.Black, Palette.Left) : Palette.DimStyle)
            .Add(" ")
            .Add(feet.Right ? "R" : Lifted, feet.Right ? new Style(Color.Black, Palette.Right) : Palette.DimStyle);
    }

    private readonly record struct Column(string Title, int Narrow, int Wide, Justify Alignment, int From = 0, string? Short = null)
    {
        public int WidthWhen(bool isWide) => isWide ? Wide : Narrow;

        public string TitleWhen(bool isWide)
        {
            string title = isWide ? Title : Short ?? Title;
            return title.Length <= WidthWhen(isWide) ? title : title[..WidthWhen(isWide)];
        }
    }
}
