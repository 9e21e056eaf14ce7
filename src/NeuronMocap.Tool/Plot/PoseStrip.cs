using System.Numerics;
using NeuronMocap.Tool.Figures;

namespace NeuronMocap.Tool.Plot;

/// <summary>
/// The rows of skeletons. Each pose is seen from the front and from the side, at the same scale, with the hips in the middle of the cell.
/// </summary>
internal sealed class PoseStrip(PointMotion motion, IReadOnlyList<SampledPose> poses, float ground)
{
    private const double Padding = 6;
    private const double MinSize = 1e-3;
    private const double LimbWidth = 2;
    private const double FineWidth = 0.9;

    private const int MaxHeights = 8;
    private const double UsualHeightStep = 50; // cm

    // As a part of the body height. Fingers are shorter than this, and limbs are longer.
    private const double FinePart = 0.065;

    private readonly double _height = Math.Max(MinSize, HeightsOf(poses, ground).Append(0).Max());

    /// <summary>Draws the two rows.</summary>
    /// <param name="svg">The picture.</param>
    /// <param name="front">Position of the upper row.</param>
    /// <param name="side">Position of the lower row, with the same size.</param>
    public void Draw(SvgDrawing svg, Box front, Box side)
    {
        double cell = front.Width / poses.Count;
        double lowest = Math.Min(0, HeightsOf(poses, ground).Append(0).Min());
        double highest = _height;
        double widest = Math.Max(MinSize, poses.Max(pose => Math.Max(Reach(pose, static point => point.X), Reach(pose, static point => point.Z))));
        double scale = Math.Min((front.Height - (2 * Padding)) / (highest - lowest), ((cell / 2) - Padding) / widest);
        svg.BeginGroup("front");
        DrawRow(svg, front, cell, scale, lowest, static point => point.X, static point => point.Z);
        svg.EndGroup();
        svg.BeginGroup("side");
        DrawRow(svg, side, cell, scale, lowest, static point => point.Z, static point => -point.X);
        svg.EndGroup();
    }

    private void DrawRow(SvgDrawing svg, Box row, double cell, double scale, double lowest, Func<Vector3, float> across, Func<Vector3, float> nearness)
    {
        double groundY = row.Bottom - Padding + (lowest * scale);
        DrawHeights(svg, row, groundY, scale);
        for (int i = 0; i < poses.Count; i++)
        {
            Vector3[] points = poses[i].Points;
            Vector3 root = points[motion.Roles.Root];
            if (!SampledPose.IsFinite(root))
                continue;

            double middle = row.Left + ((i + 0.5) * cell);
            DrawFigure(
                svg, points, point => (middle + (((double)across(point) - across(root)) * scale), groundY - (((double)point.Y - ground) * scale)), nearness, scale);
        }
    }

    // Nearer parts are drawn over the others. Each side of the body is one path of limbs and one path of fingers.
    private void DrawFigure(
        SvgDrawing svg, Vector3[] points, Func<Vector3, (double X, double Y)> project, Func<Vector3, float> nearness, double scale)
    {
        var parts = new Dictionary<BodyPart, Figure>();
        foreach (WireframeLine line in motion.Lines)
        {
            if (!SampledPose.IsFinite(points[line.From]) || !SampledPose.IsFinite(points[line.To]) || line.To == motion.Roles.HeadTop)
                continue;

            if (!parts.TryGetValue(line.Part, out Figure? figure))
                parts.Add(line.Part, figure = new Figure());

            bool isFine = line.Part != BodyPart.Middle && Distance(points[line.From], points[line.To]) < FinePart * _height;
            (double x1, double y1) = project(points[line.From]);
            (double x2, double y2) = project(points[line.To]);
            (isFine ? figure.Fine : figure.Limbs).MoveTo(x1, y1).LineTo(x2, y2);
            figure.Nearness.Add(nearness(points[line.From]) + nearness(points[line.To]));
        }

        foreach ((BodyPart part, Figure figure) in parts.OrderBy(static part => part.Value.Nearness.Average()))
        {
            svg.Stroke(figure.Limbs, PlotTheme.Of(part), LimbWidth);
            svg.Stroke(figure.Fine, PlotTheme.Of(part), FineWidth);
        }

        DrawHead(svg, points, project, scale);
    }

    private void DrawHead(SvgDrawing svg, Vector3[] points, Func<Vector3, (double X, double Y)> project, double scale)
    {
        foreach (WireframeLine line in motion.Lines)
        {
            if (line.To != motion.Roles.HeadTop || !SampledPose.IsFinite(points[line.From]) || !SampledPose.IsFinite(points[line.To]))
                continue;

            (double x1, double y1) = project(points[line.From]);
            (double x2, double y2) = project(points[line.To]);
            svg.Circle((x1 + x2) / 2, (y1 + y2) / 2, Distance(points[line.From], points[line.To]) / 2 * scale, PlotTheme.Paper, PlotTheme.Middle, LimbWidth);
        }
    }

    private void DrawHeights(SvgDrawing svg, Box row, double groundY, double scale)
    {
        double top = (groundY - row.Top) / scale;
        double step = motion.IsInCentimetres && top <= MaxHeights * UsualHeightStep ? UsualHeightStep : AxisTicks.Step(top, 3);
        foreach (double height in AxisTicks.Between(0, top, step))
        {
            double y = groundY - (height * scale);
            svg.Line(row.Left, y, row.Right, y, height == 0 ? PlotTheme.Axis : PlotTheme.Grid);
            svg.Text(
                row.Left - 8,
                y + 4,
                motion.IsInCentimetres ? AxisTicks.Label(height / 100, Math.Max(0.1, step / 500)) : AxisTicks.Label(height, step),
                PlotTheme.TickSize,
                PlotTheme.Dim,
                TextAnchor.End);
        }
    }

    private static IEnumerable<double> HeightsOf(IReadOnlyList<SampledPose> poses, float ground) => poses
        .SelectMany(static pose => pose.Points)
        .Select(point => (double)point.Y - ground)
        .Where(double.IsFinite);

    // Values of a damaged file may be too large to be subtracted directly.
    private static double Distance(Vector3 a, Vector3 b) =>
        Math.Sqrt(Square((double)a.X - b.X) + Square((double)a.Y - b.Y) + Square((double)a.Z - b.Z));

    private static double Square(double value) => value * value;

    private double Reach(SampledPose pose, Func<Vector3, float> across)
    {
        double root = across(pose.Points[motion.Roles.Root]);
        return pose.Points.Select(point => Math.Abs(across(point) - root)).Where(double.IsFinite).Append(0).Max();
    }

    private sealed class Figure
    {
        public SvgPath Limbs { get; } = new();

        public SvgPath Fine { get; } = new();

        public List<float> Nearness { get; } = [];
    }
}
