namespace UnityEngine.StandIn;

/// <summary>The output of Gizmos, Handles and Debug since the start of the frame, in world coordinates.</summary>
internal static class GizmoLog
{
    private static readonly List<GizmoCall> _calls = [];

    public static IReadOnlyList<GizmoCall> Calls => _calls;

    public static void Add(string shape, Color color, Vector3 from, Vector3 to) => Add(shape, color, from, to, 0);

    public static void Add(string shape, Color color, Vector3 from, Vector3 to, float size) => _calls.Add(new GizmoCall(shape, color, from, to, size));

    public static void Clear() => _calls.Clear();
}

internal readonly struct GizmoCall(string shape, Color color, Vector3 from, Vector3 to, float size)
{
    public string Shape { get; } = shape;

    public Color Color { get; } = color;

    public Vector3 From { get; } = from;

    /// <summary>The other end of a line. For a box, its size. Otherwise the same position.</summary>
    public Vector3 To { get; } = to;

    /// <summary>The radius of a sphere.</summary>
    public float Size { get; } = size;
}
