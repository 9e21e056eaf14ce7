namespace UnityEngine;

public sealed partial class Mesh : Object
{
    public Vector3[] vertices { get; set; } = [];

    public Vector3[] normals { get; set; } = [];

    public Vector2[] uv { get; set; } = [];

    public Color[] colors { get; set; } = [];

    public Bounds bounds { get; set; }

    public int vertexCount => vertices.Length;

    public void SetVertices(List<Vector3> inVertices) => vertices = [.. inVertices];

    public void Clear() => (vertices, normals, uv, triangles) = ([], [], [], []);

    public void MarkDynamic()
    {
    }

    public void RecalculateBounds()
    {
        var box = new Bounds(vertices.FirstOrDefault(), Vector3.zero);
        foreach (Vector3 vertex in vertices)
            box.Encapsulate(vertex);

        bounds = box;
    }
}

public enum MeshTopology
{
    Triangles = 0,
    Quads = 2,
    Lines = 3,
    LineStrip = 4,
    Points = 5,
}
