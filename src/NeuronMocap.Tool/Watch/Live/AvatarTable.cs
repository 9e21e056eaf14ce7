using NeuronMocap.Tool.Terminal;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>A row for each stream of each avatar, and a line of what the reader counts in all.</summary>
internal static class AvatarTable
{
    /// <summary>Lines besides the rows of avatars: head and totals.</summary>
    public const int FixedHeight = 2;

    private const int Gap = 1;
    private const int Small = 72;
    private const int Wide = 95;
    private const int Widest = 120;
    private const int WidestName = 40;
    private const string Lifted = "·";

    // Their widths are fixed, so that the table stands still while its numbers change. A small screen has room for the essential ones.
    private static readonly Column[] Columns =
    [
        new("stream", 6, 12, Justify.Left),
        new("Hz", 6, 8, Justify.Right),
        new("jitter", 8, 10, Justify.Right, From: Small),
        new("frames", 10, 12, Justify.Right),
        new("lost", 6, 8, Justify.Right),
        new("gaps", 6, 6, Justify.Right, From: Widest),
        new("disordered", 6, 11, Justify.Right, From: Small),
        new("restarts", 8, 8, Justify.Right, From: Widest),
        new("age", 7, 8, Justify.Right),
        new("feet", 4, 5, Justify.Left),
    ];

    private static readonly TimeSpan Stale = TimeSpan.FromSeconds(1);

    /// <summary>Makes the table.</summary>
    /// <param name="state">What to show.</param>
    /// <param name="rows">Room for avatars; the last one tells how many are left out, when there are more.</param>
    /// <param name="width">Columns that it may take.</param>
    public static IRenderable Create(LiveState state, int rows, int width)
    {
        bool isWide = width >= Wide;
        IReadOnlyList<AvatarStatistics> avatars = state.Counters.Avatars;
        int shown = avatars.Count <= rows ? avatars.Count : Math.Max(rows - 1, 0);
        Column[] columns = [.. Columns.Where(column => width >= column.From)];
        Table table = new Table().Border(TableBorder.None);
        int nameWidth = Math.Min(width - Gap - columns.Sum(column => Gap + column.WidthWhen(isWide)), WidestName);
        table.AddColumn(MakeColumn("avatar", nameWidth, Justify.Left));
        foreach (Column column in columns)
            table.AddColumn(MakeColumn(column.TitleWhen(isWide), column.WidthWhen(isWide), column.Alignment));

        foreach (AvatarStatistics avatar in avatars.OrderBy(avatar => (uint)avatar.AvatarIndex).ThenBy(avatar => avatar.Kind).Take(shown))
            table.AddRow(MakeRow(state, avatar, width));
        if (shown < avatars.Count)
            table.AddRow(new Text(Quantity.Format($"  and {avatars.Count - shown} more"), Palette.DimStyle));
        else if (avatars.Count == 0)
            table.AddRow(new Text("  none yet", Palette.DimStyle));

        return new Rows(table, Totals(state));
    }

    public static int CountRows(LiveState state) => Math.Max(state.Counters.Avatars.Count, 1);

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

    private static StyledLine MakeName(LiveState state, AvatarStatistics avatar)
    {
        bool isSelected = avatar.Kind == PacketKind.Motion && avatar.AvatarIndex == state.Avatar;
        string sender = avatar.Source > 0 ? Quantity.Format($" (sender {avatar.Source})") : string.Empty;
        string name = Quantity.Format($"{(isSelected ? '>' : ' ')} {(uint)avatar.AvatarIndex} {avatar.AvatarName}{sender}");
        return new StyledLine().Add(name, isSelected ? Palette.StrongStyle : Style.Plain);
    }

    // One for each of the columns.
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
            Alarm(avatar.Disordered),
            new Text(Quantity.Count(avatar.Restarts)),
            new Text(Quantity.Age(age), isStale ? new Style(Palette.Bad) : Style.Plain),
            DescribeFeet(state, avatar),
        ];
    }

    private static string NameOf(PacketKind kind, bool isWide) => kind switch
    {
        PacketKind.Motion => "motion",
        PacketKind.Calculation => isWide ? "calculation" : "calc",
        _ => isWide ? "studio calc" : "stud",
    };

    // "30.0/2": every second frame.
    private static string DescribeRate(AvatarStatistics avatar) =>
        Quantity.Fixed(avatar.Rate, 1) + (avatar.FrequencyReduction > 1 ? Quantity.Format($"/{avatar.FrequencyReduction}") : string.Empty);

    private static Text Alarm(long count) => new(Quantity.Count(count), count > 0 ? new Style(Palette.Warning) : Style.Plain);

    // Calculation data says it; motion is drawn of one avatar only, and estimated for that one.
    private static IRenderable DescribeFeet(LiveState state, AvatarStatistics avatar) => avatar.Kind switch
    {
        PacketKind.Calculation => Feet(state.GetContacts(avatar.AvatarIndex)),
        PacketKind.Motion when avatar.AvatarIndex == state.Avatar => Feet(state.EstimatedContacts),
        _ => Text.Empty,
    };

    private static Paragraph Feet(FootContacts? contacts)
    {
        if (contacts is not { } feet)
            return new Paragraph("-");

        // Letters, and not colours alone: NO_COLOR switches those off.
        return new Paragraph()
            .Append(feet.Left ? "L" : Lifted, feet.Left ? new Style(Color.Black, Palette.Left) : Palette.DimStyle)
            .Append(" ")
            .Append(feet.Right ? "R" : Lifted, feet.Right ? new Style(Color.Black, Palette.Right) : Palette.DimStyle);
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
            .AddRight($"receiving allocates {Quantity.Bytes(state.BytesAllocatedByReceiving)}/s", Palette.DimStyle);
    }

    private readonly record struct Column(string Title, int Narrow, int Wide, Justify Alignment, int From = 0)
    {
        public int WidthWhen(bool isWide) => isWide ? Wide : Narrow;

        public string TitleWhen(bool isWide) => Title.Length <= WidthWhen(isWide) ? Title : Title[..WidthWhen(isWide)];
    }
}
