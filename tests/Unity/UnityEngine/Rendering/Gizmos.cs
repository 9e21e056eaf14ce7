using UnityEngine.StandIn;

namespace UnityEngine;

public sealed class Gizmos
{
    public static Color color { get; set; } = Color.white;

    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;

    public static void DrawLine(Vector3 from, Vector3 to) => GizmoLog.Add("Line", color, matrix.MultiplyPoint3x4(from), matrix.MultiplyPoint3x4(to));

    public static void DrawRay(Vector3 from, Vector3 direction) => DrawLine(from, from + direction);

    public static void DrawSphere(Vector3 center, float radius) => Add("Sphere", center, radius);

    public static void DrawWireSphere(Vector3 center, float radius) => Add("WireSphere", center, radius);

    public static void DrawCube(Vector3 center, Vector3 size) => GizmoLog.Add("Cube", color, matrix.MultiplyPoint3x4(center), size);

    public static void DrawWireCube(Vector3 center, Vector3 size) => GizmoLog.Add("WireCube", color, matrix.MultiplyPoint3x4(center), size);

    public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Vector3 scale) => Add("Mesh", position, scale.magnitude);

    public static void DrawIcon(Vector3 center, string name) => Add("Icon", center, 0);

    private static void Add(string shape, Vector3 center, float size)
    {
        Vector3 place = matrix.MultiplyPoint3x4(center);
        GizmoLog.Add(shape, color, place, place, size);
    }
}
