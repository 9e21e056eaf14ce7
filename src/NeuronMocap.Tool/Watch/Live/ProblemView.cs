using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>Explains why no skeleton is shown, and what to do about it.</summary>
internal static class ProblemView
{
    /// <summary>Lines of the box in addition to the text.</summary>
    public const int SpaceAround = 5;

    private const int WidestText = 76;
    private const int BorderWidth = 6;

    /// <summary>Gets the height without a box, in lines.</summary>
    public static int HeightOf(in Problem problem, LiveState state, int width) =>
        1 + WrappedText.Break(problem.Message, TextWidth(width), int.MaxValue).Count + (HeaderView.DescribeRetry(state.Status, state.Now).Length > 0 ? 1 : 0);

    /// <summary>Shows the problem: in a box if there is room, otherwise in plain lines.</summary>
    /// <param name="problem">The result of <see cref="FindInPlaceOfSkeleton"/>.</param>
    /// <param name="state">The state of the view.</param>
    /// <param name="width">Available columns.</param>
    /// <param name="height">Available lines.</param>
    public static IRenderable Create(in Problem problem, LiveState state, int width, int height)
    {
        bool isFramed = HeightOf(problem, state, width) + SpaceAround <= height && width > WidestText;
        string retry = HeaderView.DescribeRetry(state.Status, state.Now);
        Style title = new(problem.Color, decoration: Decoration.Bold);
        int room = height - (retry.Length > 0 ? 1 : 0);

        // In a very low window the sentences are more important than their title.
        IReadOnlyList<string> lines = WrappedText.Break(problem.Message, TextWidth(width), Math.Max(room, 1));
        bool hasTitle = lines.Count < room;
        if (!isFramed)
        {
            return new Rows(
            [
                .. hasTitle ? [new StyledLine().Add(problem.Title, title)] : Array.Empty<StyledLine>(),
                .. lines.Select(static line => new StyledLine().Add(line)),
                .. retry.Length > 0 ? [new StyledLine().Add(retry, Palette.WarningStyle)] : Array.Empty<StyledLine>(),
            ]);
        }

        Panel panel = new Panel(new Rows(
        [
            new Text(problem.Title, title).Centered(),
            Text.Empty,
            .. lines.Select(static line => new Text(line).Centered()),
            Text.Empty,
            new Text(retry, Palette.WarningStyle).Centered(),
        ])).Border(BoxBorder.Heavy).BorderColor(problem.Color).Padding(2, 0);
        panel.Width = WidestText;
        return Align.Center(panel, VerticalAlignment.Middle);
    }

    /// <summary>Finds why no skeleton can be shown.</summary>
    /// <returns>The problem; null if a skeleton can be shown.</returns>
    public static Problem? FindInPlaceOfSkeleton(LiveState state)
    {
        ConnectionStatus status = state.Status;
        if (status.State != ConnectionState.Receiving)
            return new(status.Title().ToUpperInvariant(), status.Describe(), Palette.Of(status.State));
        if (state.Pose is { HasSkeleton: true })
            return null;

        (string title, string message, Color color) = Explain(state);
        return new(title, message, color);
    }

    // A box is as wide as its text and border. Plain lines use the whole window.
    private static int TextWidth(int width) => Math.Max(width > WidestText ? WidestText - BorderWidth : width, 1);

    private static (string Title, string Message, Color Color) Explain(LiveState state)
    {
        bool hasCalculation = state.Counters.Avatars.Any(avatar => avatar.Kind is PacketKind.Calculation or PacketKind.StudioCalculation);
        return MissingSkeleton.Explain(state.Pose?.Header.ValueCount, hasCalculation) is var (title, message)
            ? (title.ToUpperInvariant(), message, Palette.Warning)
            : ("RECEIVING", "The first frame has not arrived yet.", Palette.Of(ConnectionState.Receiving));
    }
}

/// <summary>A problem and its solution.</summary>
/// <param name="Title">The problem in a few words.</param>
/// <param name="Message">Sentences that name the setting to change; safe for a terminal.</param>
/// <param name="Color">Severity of the problem.</param>
internal readonly record struct Problem(string Title, string Message, Color Color);
