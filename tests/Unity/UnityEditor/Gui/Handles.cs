using UnityEngine;
using UnityEngine.StandIn;

namespace UnityEditor;

public static partial class Handles
{
    public static Color color { get; set; } = Color.white;

    public static void DrawLine(Vector3 p1, Vector3 p2) => Add(p1, p2, 1);

    public static void DrawAAPolyLine(float width, params Vector3[] points)
    {
        for (int i = 1; i < points.Length; i++)
            Add(points[i - 1], points[i], width);
    }

    private static void Add(Vector3 from, Vector3 to, float width)
    {
        if (Event.current.type != EventType.Repaint)
            throw new InvalidOperationException("Handles draw in the repaint pass only.");

        ImmediateGui.AddLine(from, to, color, width);
    }
}
