namespace UnityEngine;

// Triangles in submeshes, and the bones that move the vertices.
public sealed partial class Mesh
{
    private int[][] _parts = [[]];

    public BoneWeight[] boneWeights { get; set; } = [];

    public Matrix4x4[] bindposes { get; set; } = [];

    public int subMeshCount
    {
        get => _parts.Length;
        set
        {
            int before = _parts.Length;
            Array.Resize(ref _parts, value);
            for (int i = before; i < value; i++)
                _parts[i] = [];
        }
    }

    public int[] triangles
    {
        get => [.. _parts.SelectMany(static part => part)];
        set => _parts = [value];
    }

    public void SetTriangles(int[] triangles, int submesh) => _parts[submesh] = Checked(triangles);

    public void SetTriangles(List<int> triangles, int submesh) => _parts[submesh] = Checked([.. triangles]);

    public void SetIndices(int[] indices, MeshTopology topology, int submesh) => _parts[submesh] = Checked(indices);

    public int[] GetTriangles(int submesh) => [.. _parts[submesh]];

    /// <summary>Gives each vertex the mean of its triangles' normals, weighted by their areas.</summary>
    public void RecalculateNormals()
    {
        var sums = new Vector3[vertices.Length];
        int[] corners = triangles;
        for (int i = 0; i < corners.Length; i += 3)
        {
            Vector3 a = vertices[corners[i]];
            var normal = Vector3.Cross(vertices[corners[i + 1]] - a, vertices[corners[i + 2]] - a);
            for (int corner = 0; corner < 3; corner++)
                sums[corners[i + corner]] += normal;
        }

        normals = [.. sums.Select(static sum => sum.normalized)];
    }

    private int[] Checked(int[] indices)
    {
        if (indices.Any(index => index < 0 || index >= vertices.Length))
            throw new ArgumentException("Failed setting triangles. Some indices are referencing out of bounds vertices.", nameof(indices));

        return [.. indices];
    }
}
