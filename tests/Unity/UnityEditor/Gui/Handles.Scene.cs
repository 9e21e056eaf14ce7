using UnityEngine;
using UnityEngine.StandIn;

namespace UnityEditor;

// What OnDrawGizmos adds to the scene view.
public static partial class Handles
{
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;

    public static void Label(Vector3 position, string text)
    {
        Vector3 place = matrix.MultiplyPoint3x4(position);
        GizmoLog.Add("Label " + text, color, place, place);
    }
}
