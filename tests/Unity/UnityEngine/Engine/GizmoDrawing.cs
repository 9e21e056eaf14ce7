namespace UnityEngine.StandIn;

/// <summary>Asks scripts for their gizmos in the scene view.</summary>
internal static class GizmoDrawing
{
    public static void Draw(GameObject? selected)
    {
        foreach (MonoBehaviour script in World.Objects.OfType<MonoBehaviour>().Where(static script => script.IsRunning).ToArray())
        {
            Gizmos.color = Color.white;
            Gizmos.matrix = Matrix4x4.identity;
            script.State.Call("OnDrawGizmos");
            if (selected is not null && script.transform.IsChildOf(selected.transform))
                script.State.Call("OnDrawGizmosSelected");
        }
    }
}
