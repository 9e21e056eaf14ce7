using NeuronMocap.Tool.Figures;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Plot;

/// <summary>The plot of a take: skeletons at regular times, the path over the ground, and feet and speeds over time.</summary>
internal sealed class TakePlot(PointMotion motion, string title, string subtitle)
{
    public const double Width = 1200;
    public const double Height = 900;

    private const int MaxPoses = 8;
    private const double Left = 84;
    private const double Right = Width - 36;
    private const double ContactHeight = 7;

    private static readonly Box Front = new(Left, 112, Right - Left, 172);
    private static readonly Box Side = new(Left, 310, Right - Left, 172);
    private static readonly Box Map = new(Left, 570, 340, 272);

    private const double ChartLeft = 510;
    private const double ChartWidth = Right - ChartLeft;

    /// <summary>Measures the take and writes the picture.</summary>
    /// <param name="output">Receives SVG.</param>
    /// <param name="progress">Receives progress, 0 to 1.</param>
    /// <param name="cancellationToken">Cancels the work.</param>
    /// <exception cref="OperationCanceledException">The work was cancelled.</exception>
    public void Write(Stream output, IProgress<double> progress, CancellationToken cancellationToken)
    {
        TakeCurves curves = TakeCurves.Measure(motion, progress, cancellationToken);
        SampledPose[] poses = SampledPose.Take(motion, MaxPoses);
        using var svg = new SvgDrawing(output, Width, Height, title);
        DrawHeader(svg);
        DrawPoses(svg, poses, float.IsFinite(curves.Ground) ? curves.Ground : 0);
        DrawMap(svg, poses, curves);
        DrawCharts(svg, poses, curves);
    }

    private void DrawHeader(SvgDrawing svg)
    {
        svg.Text(36, 44, title, PlotTheme.TitleSize, PlotTheme.Ink, bold: true);
        svg.Text(36, 68, subtitle, PlotTheme.TextSize, PlotTheme.Dim);
        foreach ((double x, string name, string color) in ((double, string, string)[])[(Right - 144, "left", PlotTheme.Left), (Right - 62, "right", PlotTheme.Right)])
        {
            svg.Rectangle(new Box(x, 61.5, 22, 5), color);
            svg.Text(x + 30, 68, name, PlotTheme.TextSize, PlotTheme.Dim);
        }
    }

    private void DrawPoses(SvgDrawing svg, SampledPose[] poses, float ground)
    {
        string unit = motion.IsInCentimetres ? "height in m" : "height in units of the file";
        svg.Text(Left, Front.Top - 8, $"Front, seen from +Z ({unit})");
        svg.Text(Left, Side.Top - 8, $"Side, seen from −X ({unit})");
        new PoseStrip(motion, poses, ground).Draw(svg, Front, Side);
        double cell = Side.Width / poses.Length;
        for (int i = 0; i < poses.Length; i++)
        {
            svg.Text(
                Side.Left + ((i + 0.5) * cell), Side.Bottom + 18, Quantity.Format($"{poses[i].Seconds:0.00} s"), PlotTheme.LabelSize, PlotTheme.Dim, TextAnchor.Middle);
        }
    }

    private void DrawMap(SvgDrawing svg, SampledPose[] poses, TakeCurves curves)
    {
        svg.Text(Left, Map.Top - 8, motion.IsInCentimetres ? "Path on the ground, from above (m)" : "Path on the ground, from above (units)");
        new GroundMap(motion, poses, curves).Draw(svg, Map);
        svg.Text(Map.Right, Map.Bottom + 36, "X →", PlotTheme.TickSize, PlotTheme.Dim, TextAnchor.End);
        if (curves.LeftContacts is not null)
            svg.Text(Map.Left + (Map.Width / 2), Map.Bottom + 36, "hollow arrow: start; dots: feet set down", PlotTheme.TickSize, PlotTheme.Dim, TextAnchor.Middle);

        svg.Text(Map.Left - 8, Map.Bottom + 36, "Z ↓", PlotTheme.TickSize, PlotTheme.Dim, TextAnchor.End);
    }

    private void DrawCharts(SvgDrawing svg, SampledPose[] poses, TakeCurves curves)
    {
        (string height, string speed, double metres) = motion.IsInCentimetres ? ("cm", "m/s", 0.01) : ("units", "units/s", 1);
        TimeChart feet = ChartAt("feet", 570, 66);
        TimeChart root = ChartAt("hips", 690, 60);
        TimeChart hands = ChartAt("hands", 782, 60);
        foreach (SampledPose pose in poses)
            svg.Line(feet.X(pose.Seconds), feet.Box.Top, feet.X(pose.Seconds), hands.Box.Bottom, PlotTheme.Grid);

        feet.Draw(
            svg,
            curves.LeftContacts is null ? $"Height of the feet ({height})" : $"Height of the feet ({height}); bars: on the ground",
            [new ChartLine(curves.LeftFoot, PlotTheme.Left), new ChartLine(curves.RightFoot, PlotTheme.Right)],
            curves.Ground,
            1,
            motion.IsInCentimetres ? 5 : 0.05);
        DrawContacts(svg, feet, curves.LeftContacts, PlotTheme.Left, feet.Box.Bottom + 5);
        DrawContacts(svg, feet, curves.RightContacts, PlotTheme.Right, feet.Box.Bottom + 5 + ContactHeight + 2);
        root.Draw(svg, $"{(motion.IsInCentimetres ? "Speed of the hips" : "Speed of the root")} over the ground ({speed})", [new ChartLine(curves.Root, PlotTheme.Middle)], 0, metres, 0.5);
        hands.Draw(
            svg,
            $"Speed of the hands ({speed})",
            [new ChartLine(curves.LeftHand, PlotTheme.Left), new ChartLine(curves.RightHand, PlotTheme.Right)],
            0,
            metres,
            0.5);
        hands.DrawTimes(svg, "seconds");
    }

    private TimeChart ChartAt(string name, double top, double height) => new(name, new Box(ChartLeft, top, ChartWidth, height), motion.FrameRate, motion.Duration);

    private void DrawContacts(SvgDrawing svg, TimeChart chart, ContactTrack? track, string color, double top)
    {
        if (track is null)
            return;

        svg.Rectangle(chart.Box with { Top = top, Height = ContactHeight }, PlotTheme.Grid);
        foreach ((double start, double end) in Merge(track.Steps, motion.FrameRate, motion.Duration / ChartWidth))
            svg.Rectangle(new Box(chart.X(start), top, chart.X(end) - chart.X(start), ContactHeight), color);
    }

    // Steps less than a pixel apart are drawn as one, because a take of hours has thousands.
    private static IEnumerable<(double Start, double End)> Merge(IReadOnlyList<ContactTrack.Step> steps, double frameRate, double pixel)
    {
        (double Start, double End)? open = null;
        foreach (ContactTrack.Step step in steps)
        {
            (double start, double end) = (step.Start / frameRate, step.End / frameRate);
            if (open is { } before && start - before.End < pixel)
            {
                open = (before.Start, end);
                continue;
            }

            if (open is { } done)
                yield return done;

            open = (start, end);
        }

        if (open is { } last)
            yield return last;
    }
}
