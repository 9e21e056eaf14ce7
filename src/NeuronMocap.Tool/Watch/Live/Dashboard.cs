using NeuronMocap.Tool.Play;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>Puts the views together for a size of the terminal: bare at 80 x 24, framed when there is room.</summary>
internal static class Dashboard
{
    public const int SmallestWidth = 60;
    public const int SmallestHeight = 16;

    private const int FramedWidth = 100;
    private const int FramedHeight = 32;
    private const int WideWidth = 150;
    private const int FooterHeight = 1;

    private static readonly (string Key, string Action)[] Keys =
        [("q", "quit"), ("space", "pause"), ("r", "reset"), ("tab", "avatar"), ("b", "bones"), ("?", "help")];

    public static IRenderable Create(LiveState state, int width, int height)
    {
        if (width < SmallestWidth || height < SmallestHeight)
            return CompactView.Create(state, width, height);

        bool framed = width >= FramedWidth && height >= FramedHeight;
        int border = framed ? 2 : 0;
        int avatarRows = Math.Min(AvatarTable.CountRows(state), Math.Max(2, height / 6));
        int avatarHeight = avatarRows + AvatarTable.FixedHeight + border;
        int eventRows = framed ? Math.Max(3, height / 8) : height >= 30 ? 4 : 2;
        int headerHeight = HeaderView.HeightOf(state, width);
        int bodyHeight = height - headerHeight - avatarHeight - eventRows - border - FooterHeight;
        return new Layout().SplitRows(
            Fixed(HeaderView.Create(state, width), headerHeight),
            Fixed(Frame("avatars", AvatarTable.Create(state, avatarRows, framed ? width - 4 : width), framed), avatarHeight),
            CreateBody(state, width, bodyHeight, framed),
            Fixed(Frame("events", CreateEvents(state.Events, eventRows), framed), eventRows + border),
            Fixed(CreateFooter(isPlayback: state.Player is not null), FooterHeight));
    }

    private static Layout Fixed(IRenderable content, int height) => new Layout(content).Size(height);

    private static IRenderable Frame(string title, IRenderable content, bool framed)
    {
        if (!framed)
            return content;

        Panel panel = new Panel(content).Border(BoxBorder.Rounded).BorderColor(Palette.Ground).Padding(1, 0).Expand();
        panel.Header = new PanelHeader($"\u00A0{Markup.Escape(title)}\u00A0");
        return panel;
    }

    private static Layout CreateBody(LiveState state, int width, int height, bool framed)
    {
        if (state.ShowsHelp)
            return Fixed(Frame("help", HelpView.Create(state.Player is not null), framed), height);
        if (state.Pose is not { HasSkeleton: true } pose || state.Status.State != ConnectionState.Receiving)
            return Fixed(ProblemView.Create(ProblemView.Find(state) ?? default, state, width, height), height);

        int inner = height - (framed ? 2 : 0);
        BonePage page = BoneSets.GetPage(state.BonePage, inner - BoneTable.HeadHeight - (framed ? 0 : 1));
        var boneTable = new BoneTable(pose, page.Bones, isWide: width >= WideWidth);
        int tableSpace = boneTable.Width + (framed ? 4 : 0);
        int drawingWidth = width - tableSpace - (framed ? 4 : 1);
        IRenderable table = boneTable.Create();
        if (!framed)
            table = new Rows(new StyledLine().Add($"bones: {page.Title}", Palette.DimStyle), table);

        return Fixed(Text.Empty, height).SplitColumns(
            new Layout(Frame("skeleton", CreateDrawing(state, pose, drawingWidth, inner), framed)),
            new Layout(Frame($"bones: {page.Title}", table, framed)).Size(tableSpace));
    }

    private static Columns CreateDrawing(LiveState state, Pose pose, int width, int height)
    {
        int half = (width - 1) / 2;
        return new Columns(
            SkeletonView.Draw(pose, Viewpoint.Front, state.Scale, half, height),
            SkeletonView.Draw(pose, Viewpoint.Side, state.Scale, half, height))
        {
            Expand = false,
            Padding = new Padding(0, 0, 1, 0),
        };
    }

    private static Rows CreateEvents(EventLog log, int rows)
    {
        IEnumerable<IRenderable> lines = log.Newest(rows).Select(entry => new StyledLine()
            .Add($"{entry.Time:HH:mm:ss} ", Palette.DimStyle)
            .Add("● ", new Style(entry.Color))
            .Add(entry.Count > 1 ? $"{entry.Count} times: " : string.Empty)
            .Add(entry.Text, Palette.DimStyle));
        return new Rows(lines);
    }

    /// <summary>The keys, and what each does in a word.</summary>
    public static IEnumerable<(string Key, string Action)> KeysOf(bool isPlayback) => isPlayback ? [Keys[0], .. PlaybackKeys.Hints, .. Keys[2..]] : Keys;

    private static StyledLine CreateFooter(bool isPlayback)
    {
        var line = new StyledLine();
        foreach ((string key, string action) in KeysOf(isPlayback))
            line.Add(key, Palette.StrongStyle).Add($" {action}   ", Palette.DimStyle);

        return line.AddColouredRight("■ left ", new Style(Palette.Left)).AddColouredRight("■ right", new Style(Palette.Right));
    }
}
