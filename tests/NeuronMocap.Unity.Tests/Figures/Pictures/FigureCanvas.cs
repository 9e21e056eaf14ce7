namespace NeuronMocap.Unity.Tests.Figures.Pictures;

/// <summary>
/// Draws skinned meshes as a triangle renderer does: bones and weights, two colours, a sun, a sky, shadows on the ground. It shows shapes and poses.
/// It is not Unity's renderer.
/// </summary>
internal sealed class FigureCanvas
{
    // Samples along each side of a pixel.
    private const int Samples = 3;

    private static readonly Vector3 Sun = new Vector3(0.45f, 0.9f, 0.5f).normalized;
    private static readonly Color ShadowColor = new(0.84f, 0.855f, 0.885f);

    private readonly int _width;
    private readonly int _height;
    private readonly Color[] _colors;
    private readonly float[] _depths;

    public FigureCanvas(int width, int height)
    {
        (Width, Height) = (width, height);
        (_width, _height) = (width * Samples, height * Samples);
        _colors = new Color[_width * _height];
        _depths = new float[_width * _height];
        Array.Fill(_colors, new Color(0.96f, 0.965f, 0.975f));
        Array.Fill(_depths, float.PositiveInfinity);
    }

    public int Width { get; }

    public int Height { get; }

    /// <summary>Draws a figure from a direction.</summary>
    /// <param name="renderer">The renderer to draw, posed by its bones.</param>
    /// <param name="ground">The place on the ground at the centre of the picture.</param>
    /// <param name="view">The direction from the ground to the eye.</param>
    /// <param name="at">The position of that place on the picture, in pixels.</param>
    /// <param name="scale">Pixels for each metre.</param>
    public void Draw(SkinnedMeshRenderer renderer, Vector3 ground, Vector3 view, Vector2 at, float scale)
    {
        view = view.normalized;
        Vector3 right = Vector3.Cross(view, Vector3.up).normalized;
        Vector3 up = Vector3.Cross(right, view);
        Vector3 light = ((view * Sun.z) - (right * Sun.x) + (Vector3.up * Sun.y)).normalized;
        Mesh mesh = renderer.sharedMesh!;
        (Vector3[] places, Vector3[] normals) = Skin(renderer, mesh);
        Vector3[] shadows = [.. places.Select(place => place - (light * (place.y / light.y)))];

        for (int part = 0; part < mesh.subMeshCount; part++)
            Fill(mesh.GetTriangles(part), shadows, static (_, _, _) => ShadowColor, depth: 1e6f);

        for (int part = 0; part < mesh.subMeshCount; part++)
        {
            Color color = renderer.sharedMaterials[part]!.GetColor("_Color");
            int[] corners = mesh.GetTriangles(part);
            Fill(corners, places, (triangle, b, c) => Shade(color, Mix(normals, corners, triangle, b, c), light, view), depth: null);
        }

        void Fill(int[] corners, Vector3[] points, Func<int, float, float, Color> shade, float? depth)
        {
            for (int i = 0; i < corners.Length; i += 3)
                FillTriangle(Project(points[corners[i]]), Project(points[corners[i + 1]]), Project(points[corners[i + 2]]), i, shade, depth);
        }

        Vector3 Project(Vector3 place)
        {
            Vector3 way = place - ground;
            return new Vector3(
                (at.x - (Vector3.Dot(way, right) * scale)) * Samples,
                (at.y - (Vector3.Dot(way, up) * scale)) * Samples,
                -Vector3.Dot(way, view));
        }
    }

    /// <summary>Returns red, green and blue of every pixel, row by row.</summary>
    public byte[] ToPixels()
    {
        var pixels = new byte[3 * Width * Height];
        for (int i = 0; i < Width * Height; i++)
        {
            var sum = default(Color);
            for (int sample = 0; sample < Samples * Samples; sample++)
                sum += _colors[(((i / Width * Samples) + (sample / Samples)) * _width) + (i % Width * Samples) + (sample % Samples)];

            sum *= 255f / (Samples * Samples);
            (pixels[3 * i], pixels[(3 * i) + 1], pixels[(3 * i) + 2]) = ((byte)sum.r, (byte)sum.g, (byte)sum.b);
        }

        return pixels;
    }

    private static (Vector3[] Places, Vector3[] Normals) Skin(SkinnedMeshRenderer renderer, Mesh mesh)
    {
        Matrix4x4[] moves = [.. renderer.bones.Select((bone, i) => bone.localToWorldMatrix * mesh.bindposes[i])];
        var places = new Vector3[mesh.vertexCount];
        var normals = new Vector3[mesh.vertexCount];
        for (int i = 0; i < places.Length; i++)
        {
            Matrix4x4 move = moves[mesh.boneWeights[i].boneIndex0];
            places[i] = move.MultiplyPoint3x4(mesh.vertices[i]);
            normals[i] = move.MultiplyVector(mesh.normals[i]);
        }

        return (places, normals);
    }

    private static Vector3 Mix(Vector3[] values, int[] corners, int triangle, float b, float c) =>
        ((values[corners[triangle]] * (1 - b - c)) + (values[corners[triangle + 1]] * b) + (values[corners[triangle + 2]] * c)).normalized;

    private static Color Shade(Color color, Vector3 normal, Vector3 light, Vector3 view)
    {
        float sun = Mathf.Max(0, Vector3.Dot(normal, light));
        float sky = 0.5f + (0.5f * normal.y);
        float shine = Mathf.Pow(Mathf.Max(0, Vector3.Dot(normal, (light + view).normalized)), 40);
        Color lit = (color * ((0.52f * sun) + (0.36f * sky) + 0.24f)) + (Color.white * (0.12f * shine));
        return new Color(Mathf.Clamp01(lit.r), Mathf.Clamp01(lit.g), Mathf.Clamp01(lit.b));
    }

    // Fills both sides, whatever the direction of the corners. Another test checks which side is shown.
    private void FillTriangle(Vector3 a, Vector3 b, Vector3 c, int triangle, Func<int, float, float, Color> shade, float? depth)
    {
        float area = ((b.x - a.x) * (c.y - a.y)) - ((b.y - a.y) * (c.x - a.x));
        if (Mathf.Abs(area) < 1e-6f)
            return;

        int left = Math.Max(0, (int)Math.Min(a.x, Math.Min(b.x, c.x)));
        int right = Math.Min(_width - 1, (int)Math.Max(a.x, Math.Max(b.x, c.x)));
        int top = Math.Max(0, (int)Math.Min(a.y, Math.Min(b.y, c.y)));
        int bottom = Math.Min(_height - 1, (int)Math.Max(a.y, Math.Max(b.y, c.y)));
        for (int y = top; y <= bottom; y++)
        {
            for (int x = left; x <= right; x++)
            {
                float ofB = (((x - a.x) * (c.y - a.y)) - ((y - a.y) * (c.x - a.x))) / area;
                float ofC = (((b.x - a.x) * (y - a.y)) - ((b.y - a.y) * (x - a.x))) / area;
                int pixel = (y * _width) + x;
                float far = depth ?? (a.z + (ofB * (b.z - a.z)) + (ofC * (c.z - a.z)));
                if (ofB < 0 || ofC < 0 || ofB + ofC > 1 || far >= _depths[pixel])
                    continue;

                _depths[pixel] = far;
                _colors[pixel] = shade(triangle, ofB, ofC);
            }
        }
    }
}
