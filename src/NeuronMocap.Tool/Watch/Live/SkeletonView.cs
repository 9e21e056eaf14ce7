using System.Numerics;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>Where the viewer stands.</summary>
internal enum Viewpoint
{
    /// <summary>Before the world, looking along -Z: the left of a person who faces +Z is on the right, as face to face.</summary>
    Front,

    /// <summary>Looking along +X: a person who faces +Z shows the right side and looks to the right.</summary>
    Side,
}

/// <summary>Draws a pose as seen from one side, with the hips in the middle and the ground at y = 0.</summary>
internal static class SkeletonView
{
    private const float GroundMark = 50;
    private const int RoomForLongName = 15;

    public static BrailleCanvas Draw(Pose pose, Viewpoint viewpoint, ViewScale scale, int columns, int rows)
    {
        var canvas = new BrailleCanvas(columns, rows);
        if (columns < 1 || rows < 1)
            return canvas;

        var projection = new Projection(canvas, scale, viewpoint, pose.GetPosition(Bone.Hips));
        DrawGround(canvas, projection);
        DrawLines(canvas, projection, pose);
        (string name, string from) = viewpoint == Viewpoint.Front ? ("front", " (from +Z)") : ("side", " (from -X)");
        canvas.Write(0, 0, columns >= RoomForLongName ? name + from : name, Palette.Dim);
        return canvas;
    }

    // The marks stand still in the world, so that a walk shows although the view follows it.
    private static void DrawGround(BrailleCanvas canvas, Projection projection)
    {
        float y = projection.Vertical(0);
        canvas.DrawLine(0, y, canvas.Width - 1, y, Palette.Ground);
        float first = MathF.Ceiling(projection.Leftmost / GroundMark) * GroundMark;
        for (float mark = first; mark <= projection.Rightmost; mark += GroundMark)
            canvas.DrawLine(projection.Horizontal(mark), y, projection.Horizontal(mark), y + 2, Palette.Ground);
    }

    // What is nearer is drawn later and wins the colour of a cell.
    private static void DrawLines(BrailleCanvas canvas, Projection projection, Pose pose)
    {
        WireframeLine[] lines = Wireframe.Lines(pose.Format.Variant).ToArray();
        Vector3[] points = pose.Points.ToArray();
        foreach (WireframeLine line in lines.OrderBy(line => projection.Nearness(points[line.From]) + projection.Nearness(points[line.To])))
        {
            Vector2 from = projection.Project(points[line.From]);
            Vector2 to = projection.Project(points[line.To]);
            if (line.To == Wireframe.HeadTop)
            {
                Vector2 middle = (from + to) / 2;
                float radius = Vector3.Distance(points[line.From], points[line.To]) / 2;
                canvas.DrawCircle(middle.X, middle.Y, radius * projection.Scale, Palette.Middle);
                continue;
            }

            canvas.DrawLine(from.X, from.Y, to.X, to.Y, Palette.Of(line.Part));
        }
    }

    private readonly struct Projection(BrailleCanvas canvas, ViewScale scale, Viewpoint viewpoint, Vector3 hips)
    {
        private readonly float _centre = viewpoint == Viewpoint.Front ? hips.X : hips.Z;
        private readonly float _middle = (canvas.Width - 1) / 2f;

        // Below the ground stays what the scale asks for; room that is left over goes above the head.
        private readonly float _ground = canvas.Height - 1 + (scale.Bottom * scale.DotsPerCentimetre(canvas));

        public float Scale { get; } = scale.DotsPerCentimetre(canvas);

        public float Leftmost => _centre - (_middle / Scale);

        public float Rightmost => _centre + (_middle / Scale);

        public float Horizontal(float centimetres) => _middle + ((centimetres - _centre) * Scale);

        public float Vertical(float centimetres) => _ground - (centimetres * Scale);

        public Vector2 Project(Vector3 point) => new(Horizontal(viewpoint == Viewpoint.Front ? point.X : point.Z), Vertical(point.Y));

        public float Nearness(Vector3 point) => viewpoint == Viewpoint.Front ? point.Z : -point.X;
    }
}
