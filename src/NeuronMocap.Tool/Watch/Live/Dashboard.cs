using NeuronMocap.Tool.Terminal;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>Arranges the views for the size of the window.</summary>
/// <remarks>
/// Explanations are never cut; they are wrapped. A view without room is left out as a whole, the least important view first.
/// </remarks>
internal static class Dashboard
{
    /// <summary>Minimum width of a window with a table of bones and with all columns for the avatars.</summary>
    public const int TableWidth = 60;

    private const int FramedWidth = 100;
    private const int FramedHeight = 32;
    private const int WideWidth = 150;
    private const int FooterHeight = 1;
    private const int BorderHeight = 2;
    private const int BorderWidth = 4;
    private const int ShortestBody = 5;

    // Lines that the drawing keeps before another view appears beside it.
    private const int BodyBesideTotals = 7;
    private const int BodyBesideDetails = 9;
    private const int BodyBesideEvents = 11;

    public static IRenderable Create(LiveState state, int width, int height)
    {
        IReadOnlyList<StyledLine> head = HeaderView.Essentials(state, width);
        int room = height - head.Count - FooterHeight;
        if (room < 1)
            return new Rows(head.Take(height));

        List<Layout> parts = [Lines(head)];
        if (state.HelpPage is { } page)
            parts.Add(Fixed(HelpView.Create(state.Player is not null, page, width, room), room));
        else if (ProblemView.FindInPlaceOfSkeleton(state) is { } problem)
            parts.AddRange(CreateProblem(problem, state, width, height, room));
        else
            parts.AddRange(CreateStream(state, width, height, room));

        parts.Add(Fixed(Footer.Create(state, width), FooterHeight));
        return new Layout().SplitRows([.. parts]);
    }

    /// <summary>Counts the pages of the help in this window.</summary>
    public static int CountHelpPages(LiveState state, int width, int height) => HelpView.CountPages(
        state.Player is not null, width, height - HeaderView.Essentials(state, width).Count - FooterHeight);

    // The reason comes first. The previous statistics stay as far as there is room.
    private static IEnumerable<Layout> CreateProblem(Problem problem, LiveState state, int width, int height, int room)
    {
        int body = ProblemView.HeightOf(problem, state, width);
        bool framed = IsFramed(width, height);
        var after = new List<Layout>();
        int rest = room - Math.Min(body, room);
        int avatars = state.Counters.Avatars.Count == 0 ? 0 : AvatarTable.HeightOf(state, width, RowsOf(height), framed);
        if (avatars > 0 && avatars <= rest)
        {
            after.Add(Avatars(state, width, RowsOf(height), framed));
            rest -= avatars;
        }

        // The box gets empty lines around it before it gets events below it.
        int events = Math.Min(EventRows(height, framed), rest - ProblemView.SpaceAround - (framed ? BorderHeight : 0));
        if (events > 0)
        {
            after.Add(Events(state, width, events, framed));
            rest -= events + (framed ? BorderHeight : 0);
        }

        int space = Math.Min(body, room) + rest;
        return [Fixed(ProblemView.Create(problem, state, width, space), space), .. after];
    }

    private static List<Layout> CreateStream(LiveState state, int width, int height, int room)
    {
        bool framed = IsFramed(width, height);
        int rows = Math.Min(RowsOf(height), Math.Max(room - ShortestBody, 1));
        int body = room - AvatarTable.HeightOf(state, width, rows, framed);
        IReadOnlyList<StyledLine> totals = Grant(AvatarTable.Totals(state, framed ? width - BorderWidth : width), BodyBesideTotals, ref body);
        IReadOnlyList<StyledLine> sentence = Grant(HeaderView.Sentence(state, width), BodyBesideDetails, ref body);
        IReadOnlyList<StyledLine> stream = Grant(HeaderView.Stream(state, width), BodyBesideDetails, ref body);
        int border = framed ? BorderHeight : 0;
        int events = Math.Min(EventRows(height, framed), body - BodyBesideEvents - border);
        if (events > 0)
            body -= events + border;

        var parts = new List<Layout>();
        if (sentence.Count + stream.Count > 0)
            parts.Add(Lines([.. sentence, .. stream]));

        parts.Add(Avatars(state, width, rows, framed, totals));
        if (body > 0)
            parts.Add(CreateBody(state, width, body, framed));
        if (events > 0)
            parts.Add(Events(state, width, events, framed));

        return parts;
    }

    // Shows lines only if the drawing keeps enough of its own.
    private static IReadOnlyList<StyledLine> Grant(IReadOnlyList<StyledLine> lines, int least, ref int body)
    {
        if (body - lines.Count < least)
            return [];

        body -= lines.Count;
        return lines;
    }

    private static bool IsFramed(int width, int height) => width >= FramedWidth && height >= FramedHeight;

    private static int RowsOf(int height) => Math.Max(2, height / 6);

    private static int EventRows(int height, bool framed) => framed ? Math.Max(3, height / 8) : height >= 30 ? 4 : 2;

    private static Layout Fixed(IRenderable content, int height) => new Layout(content).Size(height);

    private static Layout Lines(IReadOnlyList<StyledLine> lines) => Fixed(new Rows(lines), lines.Count);

    private static IRenderable Frame(string title, IRenderable content, bool framed)
    {
        if (!framed)
            return content;

        Panel panel = new Panel(content).Border(BoxBorder.Rounded).BorderColor(Palette.Ground).Padding(1, 0).Expand();
        panel.Header = new PanelHeader($"\u00A0{Markup.Escape(title)}\u00A0");
        return panel;
    }

    private static Layout Avatars(LiveState state, int width, int rows, bool framed, IReadOnlyList<StyledLine>? totals = null)
    {
        IRenderable table = AvatarTable.Create(state, rows, framed ? width - BorderWidth : width);
        return Fixed(
            Frame("avatars", new Rows([table, .. totals ?? []]), framed), AvatarTable.HeightOf(state, width, rows, framed) + (totals?.Count ?? 0));
    }

    private static Layout Events(LiveState state, int width, int rows, bool framed) => Fixed(
        Frame("events", new Rows(EventList.Create(state.Events, framed ? width - BorderWidth : width, rows)), framed), rows + (framed ? BorderHeight : 0));

    private static Layout CreateBody(LiveState state, int width, int height, bool framed)
    {
        int inner = height - (framed ? BorderHeight : 0);
        int border = framed ? BorderWidth : 0;
        BonePage? page = width < TableWidth ? null : BoneSets.GetPage(state.BonePage, inner - BoneTable.HeadHeight - (framed ? 0 : 1));
        if (page is not { } bones || state.Pose is not { HasSkeleton: true } pose)
            return Fixed(Frame("skeleton", SkeletonPanel.Create(state, width - border, inner), framed), height);

        var boneTable = new BoneTable(pose, bones.Bones, isWide: width >= WideWidth);
        int tableSpace = boneTable.Width + border;
        int drawingWidth = width - tableSpace - (framed ? BorderWidth : 1);
        string title = state.Views.Count > 1 ? Quantity.Format($"bones of {state.Selected?.Avatar}: {bones.Title}") : $"bones: {bones.Title}";
        IRenderable table = boneTable.Create();
        if (!framed)
            table = new Rows(new StyledLine().Add(title, Palette.DimStyle), table);

        return Fixed(Text.Empty, height).SplitColumns(
            new Layout(Frame("skeleton", SkeletonPanel.Create(state, drawingWidth, inner), framed)),
            new Layout(Frame(title, table, framed)).Size(tableSpace));
    }
}
