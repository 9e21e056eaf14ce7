using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>What matters most in a window that is too small for the drawing: state, what is wrong in full, and the rates.</summary>
internal static class CompactView
{
    // Badge and source; what a larger window shows.
    private const int FixedLines = 2;

    private const int MostFailureLines = 3;

    public static IRenderable Create(LiveState state, int width, int height)
    {
        var lines = new List<IRenderable> { Head(state) };
        if (state.ShowsHelp)
        {
            lines.AddRange(Dashboard.KeysOf(state.Player is not null).Select(static entry => new StyledLine().Add($"{entry.Key,-6}", Palette.StrongStyle).Add(entry.Action)));
            return new Rows(lines.Take(height));
        }

        foreach (FileFailure failure in state.FileFailures)
            lines.AddRange(WrappedText.Break(failure.Text, width, MostFailureLines).Select(line => new StyledLine().Add(line, new Style(Palette.Bad))));

        int room = height - FixedLines - lines.Count + 1;
        if (ProblemView.Find(state) is { } problem)
        {
            string retry = HeaderView.DescribeRetry(state.Status, state.Now);
            lines.AddRange(WrappedText.Break(problem.Message, width, retry.Length > 0 ? room - 1 : room).Select(line => new StyledLine().Add(line, new Style(problem.Color))));
            if (retry.Length > 0)
                lines.Add(new StyledLine().Add(retry, new Style(Palette.Warning)));
        }

        // The figures that were there stay, as far as there is room.
        foreach (AvatarStatistics avatar in state.Counters.Avatars.OrderBy(avatar => (uint)avatar.AvatarIndex).ThenBy(avatar => avatar.Kind))
        {
            if (lines.Count < height - 1)
                lines.Add(Describe(avatar));
        }

        lines.Add(new StyledLine().Add($"q quit · ? keys · skeleton from {Dashboard.SmallestWidth} x {Dashboard.SmallestHeight}", Palette.DimStyle));
        return new Rows(lines.Take(height));
    }

    private static StyledLine Head(LiveState state) => new StyledLine()
        .Add($" {state.Status.State.ToString().ToUpperInvariant()} ", new Style(Color.Black, Palette.Of(state.Status.State), Decoration.Bold))
        .Add(" ")
        .Add(HeaderView.DescribeSource(state), Palette.StrongStyle);

    private static StyledLine Describe(AvatarStatistics avatar)
    {
        string kind = avatar.Kind == PacketKind.Motion ? string.Empty : " calc";
        return new StyledLine()
            .Add(Quantity.Format($"{(uint)avatar.AvatarIndex} {avatar.AvatarName}{kind}"))
            .AddRight(Quantity.Format($" {avatar.Rate:0.0} Hz, lost {avatar.Lost:#,0}"), avatar.Lost > 0 ? new Style(Palette.Warning) : Style.Plain);
    }
}
