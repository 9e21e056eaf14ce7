using System.Numerics;
using NeuronMocap.Tool.Figures;

namespace NeuronMocap.Tool.Plot;

/// <summary>The path of the hips over the ground, seen from above, with the positions of the feet.</summary>
/// <remarks>X points right and Z down, so the viewer of the front pictures stands below the map.</remarks>
internal sealed class GroundMap(PointMotion motion, IReadOnlyList<SampledPose> poses, TakeCurves curves)
{
    private const double MarginShare = 0.08;
    private const int MaxFootprints = 400;
    private const double BriefestStep = 0.08;

    public void Draw(SvgDrawing svg, Box box)
    {
        View view = Fit(box);
        DrawGrid(svg, box, view);
        svg.BeginGroup("steps");
        DrawFootprints(svg, view);
        svg.EndGroup();
        svg.BeginGroup("path");
        var path = new SvgPath();
        bool inside = false;
        foreach (Vector3 place in curves.Trail)
        {
            if (!SampledPose.IsFinite(place))
            {
                inside = false;
                continue;
            }

            (double x, double y) = view.Project(place);
            _ = inside ? path.LineTo(x, y) : path.MoveTo(x, y);
            inside = true;
        }

        svg.Stroke(path, PlotTheme.Middle, 1.4);
        svg.EndGroup();
        DrawMoments(svg, view);
    }

    private View Fit(Box box)
    {
        IEnumerable<Vector3> places = curves.Trail.Concat(Footprints().Select(static print => print.Place)).Where(SampledPose.IsFinite);
        double left = double.PositiveInfinity, right = double.NegativeInfinity, top = double.PositiveInfinity, bottom = double.NegativeInfinity;
        foreach (Vector3 place in places)
        {
            (left, right) = (Math.Min(left, place.X), Math.Max(right, place.X));
            (top, bottom) = (Math.Min(top, place.Z), Math.Max(bottom, place.Z));
        }

        if (left > right)
            (left, right, top, bottom) = (0, 0, 0, 0);

        // If the person stands still, the map is not magnified until the sway fills it.
        double least = motion.IsInCentimetres ? 100 : Math.Max(1e-3, Height());
        double width = Math.Max(least, (right - left) * (1 + (2 * MarginShare)));
        double height = Math.Max(least, (bottom - top) * (1 + (2 * MarginShare)));
        double scale = Math.Min(box.Width / width, box.Height / height);
        return new View(box, (left + right) / 2, (top + bottom) / 2, scale);
    }

    private double Height() =>
        poses.Max(static pose => pose.Points.Max(static point => point.Y) - pose.Points.Min(static point => point.Y)) is var height && double.IsFinite(height) ? height : 0;

    private void DrawGrid(SvgDrawing svg, Box box, View view)
    {
        double unit = motion.IsInCentimetres ? 100 : 1;
        double step = AxisTicks.Step(box.Width / view.Scale / unit, 6);
        foreach (double x in AxisTicks.Between(view.Left / unit, view.Right / unit, step))
        {
            double place = view.X(x * unit);
            svg.Line(place, box.Top, place, box.Bottom, PlotTheme.Grid);
            svg.Text(place, box.Bottom + 18, AxisTicks.Label(x, step), PlotTheme.TickSize, PlotTheme.Dim, TextAnchor.Middle);
        }

        foreach (double z in AxisTicks.Between(view.Top / unit, view.Bottom / unit, step))
        {
            double place = view.Y(z * unit);
            svg.Line(box.Left, place, box.Right, place, PlotTheme.Grid);
            svg.Text(box.Left - 8, place + 4, AxisTicks.Label(z, step), PlotTheme.TickSize, PlotTheme.Dim, TextAnchor.End);
        }
    }

    private void DrawFootprints(SvgDrawing svg, View view)
    {
        foreach ((Vector3 place, string color) in Footprints())
        {
            (double x, double y) = view.Project(place);
            svg.Circle(x, y, 2.6, color);
        }
    }

    private IEnumerable<(Vector3 Place, string Color)> Footprints()
    {
        if (curves.LeftContacts is not { } left || curves.RightContacts is not { } right || left.Steps.Count + right.Steps.Count > MaxFootprints)
            return [];

        return Of(left, PlotTheme.Left).Concat(Of(right, PlotTheme.Right)).Where(static print => SampledPose.IsFinite(print.Place));

        IEnumerable<(Vector3 Place, string Color)> Of(ContactTrack track, string color) => track.Steps
            .Where(step => step.End - step.Start >= BriefestStep * motion.FrameRate)
            .Select(step => (step.Place, color));
    }

    // An arrowhead shows the facing direction at the time of each skeleton. The first arrowhead is hollow.
    private void DrawMoments(SvgDrawing svg, View view)
    {
        for (int i = poses.Count - 1; i >= 0; i--)
        {
            Vector3 place = poses[i].Points[motion.Roles.Root];
            if (!SampledPose.IsFinite(place))
                continue;

            (double x, double y) = view.Project(place);
            string fill = i == 0 ? PlotTheme.Paper : PlotTheme.Middle;
            if (poses[i].Facing(motion.Roles) is not { } facing)
            {
                svg.Circle(x, y, 3.4, fill, PlotTheme.Middle, 1.4);
                continue;
            }

            (double dx, double dy) = (facing.X, facing.Z);
            SvgPath head = new SvgPath()
                .MoveTo(x + (dx * 8), y + (dy * 8))
                .LineTo(x - (dx * 4) - (dy * 4.5), y - (dy * 4) + (dx * 4.5))
                .LineTo(x - (dx * 4) + (dy * 4.5), y - (dy * 4) - (dx * 4.5))
                .Close();
            svg.Fill(head, fill, PlotTheme.Middle);
        }
    }

    private readonly struct View(Box box, double centreX, double centreZ, double scale)
    {
        public double Scale => scale;

        public double Left => centreX - (box.Width / 2 / scale);

        public double Right => centreX + (box.Width / 2 / scale);

        public double Top => centreZ - (box.Height / 2 / scale);

        public double Bottom => centreZ + (box.Height / 2 / scale);

        public double X(double x) => box.Left + (box.Width / 2) + ((x - centreX) * scale);

        public double Y(double z) => box.Top + (box.Height / 2) + ((z - centreZ) * scale);

        public (double X, double Y) Project(Vector3 place) => (X(place.X), Y(place.Z));
    }
}
