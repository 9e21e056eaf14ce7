using System.Diagnostics;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The drawings: one avatar from two sides, or several avatars side by side.</summary>
internal static class SkeletonPanel
{
    private const int NarrowestTile = 17;
    private const int Gap = 1;
    private const int CaptionHeight = 1;

    private static readonly TimeSpan Stale = TimeSpan.FromSeconds(1);

    /// <summary>Draws as many avatars as there is room for, including the selected one.</summary>
    public static IRenderable Create(LiveState state, int width, int height)
    {
        AvatarView[] views = [.. state.Views.Where(static view => view.Pose.HasSkeleton)];
        int room = Math.Max((width + Gap) / (NarrowestTile + Gap), 1);
        Tile[] tiles = [.. Choose(views, state.Selected, room)];
        if (tiles.Length == 0 || width < 1 || height <= CaptionHeight)
            return Text.Empty;

        int tileWidth = ((width + Gap) / tiles.Length) - Gap;
        return new Columns(tiles.Select(tile => Draw(state, tile, views.Length, tileWidth, height)))
        {
            Expand = false,
            Padding = new Padding(0, 0, Gap, 0),
        };
    }

    // The avatars of a page do not change while the selection moves among them. Remaining room shows the selected avatar from the side.
    private static IEnumerable<Tile> Choose(AvatarView[] views, AvatarView? selected, int room)
    {
        int shown = Math.Min(views.Length, room);
        if (shown == 0)
            yield break;

        int index = Math.Max(Array.IndexOf(views, selected), 0);
        int first = Math.Min(index / shown * shown, views.Length - shown);
        for (int i = first; i < first + shown; i++)
        {
            yield return new Tile(views[i], Viewpoint.Front);
            if (i == index && room > views.Length)
                yield return new Tile(views[i], Viewpoint.Side);
        }
    }

    private static Rows Draw(LiveState state, Tile tile, int count, int width, int height)
    {
        AvatarView view = tile.View;
        return new Rows(
            Caption(state, tile, count, width),
            SkeletonView.Draw(view.Pose, state.GetFeet(view), tile.Viewpoint, state.Scale, width, height - CaptionHeight));
    }

    private static FixedWidth Caption(LiveState state, Tile tile, int count, int width)
    {
        AvatarView view = tile.View;
        bool isSelected = ReferenceEquals(view, state.Selected);
        string side = tile.Viewpoint == Viewpoint.Front ? "front" : "side";
        TimeSpan age = Stopwatch.GetElapsedTime(view.Timestamp, state.TakenAt);
        var caption = new StyledLine();
        if (count > 1)
            caption.Add(Quantity.Format($"{(isSelected ? ">" : " ")} {view.Avatar} {view.Name} "), isSelected ? Palette.StrongStyle : Style.Plain);
        if (age > Stale && view.Timestamp > 0)
            caption.Add($"no data for {Quantity.Age(age)}", Palette.WarningStyle);
        else
            caption.Add(side, Palette.DimStyle);

        return new FixedWidth(caption, width);
    }

    private readonly record struct Tile(AvatarView View, Viewpoint Viewpoint);

    // A line with the width of the drawing below it.
    private sealed class FixedWidth(IRenderable line, int width) : Renderable
    {
        protected override Measurement Measure(RenderOptions options, int maxWidth) => new(Math.Min(width, maxWidth), Math.Min(width, maxWidth));

        protected override IEnumerable<Segment> Render(RenderOptions options, int maxWidth) => line.Render(options, Math.Min(width, maxWidth));
    }
}
