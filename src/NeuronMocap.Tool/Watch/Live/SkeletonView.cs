using System.Numerics;
using NeuronMocap.Tool.Figures;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The position of the viewer.</summary>
internal enum Viewpoint
{
    /// <summary>Looks along -Z, face to face with a person who faces +Z. The person's left is on the right.</summary>
    Front,

    /// <summary>Looks along +X. A person who faces +Z shows the right side and looks to the right.</summary>
    Side,
}

/// <summary>Draws a pose from one side, with the hips in the middle and the ground at y = 0.</summary>
internal static class SkeletonView
{
    private const float GroundMark = 50;
    private const char LeftMark = 'L';
    private const char RightMark = 'R';

    /// <summary>Draws a pose.</summary>
    /// <param name="pose">The pose.</param>
    /// <param name="feet">The feet on the ground, marked with letters on its line; null if unknown.</param>
    /// <param name="viewpoint">The position of the viewer.</param>
    /// <param name="scale">The scale of the view.</param>
    /// <param name="columns">Columns of the drawing.</param>
    /// <param name="rows">Lines of the drawing.</param>
    public static BrailleCanvas Draw(Pose pose, FootContacts? feet, Viewpoint viewpoint, ViewScale scale, int columns, int rows)
    {
        var canvas = new BrailleCanvas(columns, rows);
        if (columns < 1 || rows < 1)
            return canvas;

        var projection = new Projection(canvas, scale, viewpoint, pose.GetPosition(Bone.Hips));
        DrawGround(canvas, projection);
        DrawLines(canvas, projection, pose);
        MarkFeet(canvas, projection, pose, feet ?? default);
        return canvas;
    }

    // Writes a letter on the ground below each foot that touches it, so that contacts are visible without colours. Feet in one column get letters
    // side by side.
    private static void MarkFeet(BrailleCanvas canvas, Projection projection, Pose pose, FootContacts feet)
    {
        int row = BrailleCanvas.RowOf(projection.Vertical(0));
        int left = BrailleCanvas.ColumnOf(projection.Project(pose.GetPosition(Bone.LeftFoot)).X);
        int right = BrailleCanvas.ColumnOf(projection.Project(pose.GetPosition(Bone.RightFoot)).X);
        if (feet.Left && feet.Right && left == right)
            left++;
        if (feet.Left)
            canvas.Write(left, row, LeftMark.ToString(), Palette.Left);
        if (feet.Right)
            canvas.Write(right, row, RightMark.ToString(), Palette.Right);
    }

    // The marks are fixed in the world, so that a walk is visible although the view follows the hips.
    private static void DrawGround(BrailleCanvas canvas, Projection projection)
    {
        float y = projection.Vertical(0);
        canvas.DrawLine(0, y, canvas.Width - 1, y, Palette.Ground);
        float first = MathF.Ceiling(projection.Leftmost / GroundMark) * GroundMark;
        for (float mark = first; mark <= projection.Rightmost; mark += GroundMark)
            canvas.DrawLine(projection.Horizontal(mark), y, projection.Horizontal(mark), y + 2, Palette.Ground);
    }

    // The nearest lines come last and determine the colour of a cell.
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

            canvas.DrawLine(from.X, from.Y, to.X, to.Y, BodyColours.Of(line.Part));
        }
    }

    private readonly struct Projection(BrailleCanvas canvas, ViewScale scale, Viewpoint viewpoint, Vector3 hips)
    {
        private readonly float _centre = viewpoint == Viewpoint.Front ? hips.X : hips.Z;
        private readonly float _middle = (canvas.Width - 1) / 2f;

        // The scale gives the room below the ground. The rest of the room is above the head.
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
