using NeuronMocap.Tool.Figures;

namespace NeuronMocap.Tool.Plot;

/// <summary>A line of a chart.</summary>
internal readonly record struct ChartLine(Curve Curve, string Color);

/// <summary>A chart of values over time, in its own box with an axis on the left. Stacked charts share the time axis below the last one.</summary>
internal sealed class TimeChart(string name, Box box, double frameRate, double duration)
{
    private const double LineWidth = 1.1;
    private const int MaxTimes = 9;

    public Box Box => box;

    public double X(double seconds) => box.Left + (seconds / duration * box.Width);

    /// <summary>Draws the grid, the values and the title.</summary>
    /// <param name="svg">The picture.</param>
    /// <param name="title">The title with the unit.</param>
    /// <param name="lines">The values.</param>
    /// <param name="zero">The value at the zero of the axis.</param>
    /// <param name="scale">Units of the axis per unit of the values.</param>
    /// <param name="least">Minimum extent of the axis, in its own units.</param>
    public void Draw(SvgDrawing svg, string title, IReadOnlyList<ChartLine> lines, double zero, double scale, double least)
    {
        double highest = Math.Max(least, lines.Select(line => (line.Curve.Highest - zero) * scale).Where(double.IsFinite).Append(0).Max());
        double step = AxisTicks.Step(highest, 4);
        double top = Math.Ceiling((highest / step) - 1e-6) * step;
        svg.Text(box.Left, box.Top - 8, title, PlotTheme.LabelSize, PlotTheme.Ink);
        foreach (double value in AxisTicks.Between(0, top, step))
        {
            double y = Y(value);
            svg.Line(box.Left, y, box.Right, y, value == 0 ? PlotTheme.Axis : PlotTheme.Grid);
            svg.Text(box.Left - 8, y + 4, AxisTicks.Label(value, step), PlotTheme.TickSize, PlotTheme.Dim, TextAnchor.End);
        }

        svg.BeginGroup(name);
        foreach (ChartLine line in lines)
            svg.Stroke(PathOf(line.Curve), line.Color, LineWidth);

        svg.EndGroup();

        double Y(double value) => box.Bottom - (value / top * box.Height);

        SvgPath PathOf(Curve curve)
        {
            var path = new SvgPath();
            bool inside = false;
            foreach ((long Frame, float Value)? point in curve.Points())
            {
                if (point is not { } known)
                {
                    inside = false;
                    continue;
                }

                (double x, double y) = (X(known.Frame / frameRate), Y((known.Value - zero) * scale));
                _ = inside ? path.LineTo(x, y) : path.MoveTo(x, y);
                inside = true;
            }

            return path;
        }
    }

    /// <summary>Draws the times below the box.</summary>
    public void DrawTimes(SvgDrawing svg, string unit)
    {
        double step = AxisTicks.StepOfTime(duration, MaxTimes);
        foreach (double seconds in AxisTicks.Between(0, duration, step))
        {
            svg.Line(X(seconds), box.Bottom, X(seconds), box.Bottom + 4, PlotTheme.Axis);
            svg.Text(X(seconds), box.Bottom + 18, AxisTicks.TimeLabel(seconds, step), PlotTheme.TickSize, PlotTheme.Dim, TextAnchor.Middle);
        }

        svg.Text(box.Right, box.Bottom + 36, unit, PlotTheme.TickSize, PlotTheme.Dim, TextAnchor.End);
    }
}
