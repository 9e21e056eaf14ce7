using System.Numerics;

namespace NeuronMocap.Figures;

// Normals of a smooth surface: the mean direction of the triangles at a vertex, weighted by their areas.
internal static class SurfaceNormals
{
    public static Vector3[] Of(Vector3[] positions, params int[][] triangles)
    {
        var normals = new Vector3[positions.Length];
        foreach (int[] corners in triangles)
        {
            for (int i = 0; i < corners.Length; i += 3)
                Add(normals, positions, corners[i], corners[i + 1], corners[i + 2]);
        }

        for (int i = 0; i < normals.Length; i++)
        {
            // A body with lengths of zero has triangles without an area.
            float length = normals[i].Length();
            normals[i] = length > 0 ? normals[i] / length : Vector3.UnitY;
        }

        return normals;
    }

    // Areas of square millimetres have squares that are lost in single precision.
    private static void Add(Vector3[] normals, Vector3[] positions, int a, int b, int c)
    {
        const float Scale = 1000;
        Vector3 normal = Vector3.Cross((positions[b] - positions[a]) * Scale, (positions[c] - positions[a]) * Scale);
        normals[a] += normal;
        normals[b] += normal;
        normals[c] += normal;
    }
}
