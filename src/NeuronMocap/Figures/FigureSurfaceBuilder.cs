using System.Numerics;

namespace NeuronMocap.Figures;

// Turns shapes into vertices and triangles. A shape has a pole, rings around its axis, and another pole.
internal sealed class FigureSurfaceBuilder
{
    private const int RingsPerCap = 5;
    private const int RingsPerMuscle = 6;
    private const float ThinShape = 0.02f;

    public List<Vector3> Positions { get; } = new(8192);

    public List<Bone> Bones { get; } = new(8192);

    public List<int> BodyTriangles { get; } = new(32768);

    public List<int> AccentTriangles { get; } = new(16384);

    // joint: the rest position of the shape's bone, in metres.
    public void Add(in FigureShape shape, Vector3 joint)
    {
        ShapeSection section = ShapeSection.Of(shape);
        int first = Positions.Count;
        float startCap = Cap(shape.StartRadii);
        float endCap = Cap(shape.EndRadii);
        Positions.Add(joint + shape.Start - (section.Axis * startCap));
        int rings = 0;
        for (int ring = 1; ring <= RingsPerCap; ring++, rings++)
            AddRing(section, joint + shape.Start, (float)ring / RingsPerCap, shape.StartRadii, -startCap);

        for (int ring = 1; shape.Bulge > 0 && ring <= RingsPerMuscle; ring++, rings++)
        {
            float along = (float)ring / (RingsPerMuscle + 1);
            float thickness = 1 + (shape.Bulge * MathF.Sin(MathF.PI * MathF.Sqrt(along)));
            Vector2 radii = Vector2.Lerp(shape.StartRadii, shape.EndRadii, along) * thickness;
            AddRing(section, joint + Vector3.Lerp(shape.Start, shape.End, along), 1, radii, 0);
        }

        for (int ring = shape.IsEllipsoid ? RingsPerCap - 1 : RingsPerCap; ring >= 1; ring--, rings++)
            AddRing(section, joint + shape.End, (float)ring / RingsPerCap, shape.EndRadii, endCap);

        Positions.Add(joint + shape.End + (section.Axis * endCap));
        AddTriangles(shape.IsAccent ? AccentTriangles : BodyTriangles, first, section.Segments, rings);
        while (Bones.Count < Positions.Count)
            Bones.Add(shape.Bone);
    }

    // latitude: from the pole (0) to the full section (1).
    private void AddRing(in ShapeSection section, Vector3 centre, float latitude, Vector2 radii, float cap)
    {
        float angle = latitude * MathF.PI / 2;
        centre += section.Axis * (cap * MathF.Cos(angle));
        for (int i = 0; i < section.Segments; i++)
        {
            float turn = 2 * MathF.PI * i / section.Segments;
            Vector3 spoke = (section.Side * (radii.X * MathF.Cos(turn))) + (section.Across * (radii.Y * MathF.Sin(turn)));
            Positions.Add(centre + (spoke * MathF.Sin(angle)));
        }
    }

    private static void AddTriangles(List<int> triangles, int first, int segments, int rings)
    {
        int last = first + 1 + (rings * segments);
        for (int i = 0; i < segments; i++)
        {
            int next = (i + 1) % segments;
            AddTriangle(triangles, first, first + 1 + next, first + 1 + i);
            for (int ring = 0; ring < rings - 1; ring++)
            {
                int low = first + 1 + (ring * segments);
                int high = low + segments;
                AddTriangle(triangles, low + i, low + next, high + i);
                AddTriangle(triangles, low + next, high + next, high + i);
            }

            AddTriangle(triangles, last, last - segments + i, last - segments + next);
        }
    }

    private static void AddTriangle(List<int> triangles, int a, int b, int c)
    {
        triangles.Add(a);
        triangles.Add(b);
        triangles.Add(c);
    }

    private static float Cap(Vector2 radii) => Math.Min(radii.X, radii.Y);

    // The axis of a shape, and the two directions of its sections.
    private readonly record struct ShapeSection(Vector3 Axis, Vector3 Side, Vector3 Across, int Segments)
    {
        public static ShapeSection Of(in FigureShape shape)
        {
            Vector3 axis = shape.End - shape.Start;
            axis = axis.LengthSquared() > 1e-10f ? Vector3.Normalize(axis) : Vector3.UnitY;
            Vector3 side = shape.Side - (axis * Vector3.Dot(shape.Side, axis));
            Vector3 other = Math.Abs(axis.X) < 0.9f ? Vector3.UnitX : Vector3.UnitZ;
            side = Vector3.Normalize(side.LengthSquared() > 1e-6f ? side : Vector3.Cross(axis, other));
            int segments = Math.Max(shape.StartRadii.X, shape.EndRadii.X) < ThinShape ? 10 : 20;
            return new ShapeSection(axis, side, Vector3.Cross(axis, side), segments);
        }
    }
}
