namespace UnityEditor;

public class SceneView : EditorWindow
{
    /// <summary>For tests: the number of requested repaints.</summary>
    public static int Repainted { get; private set; }

    public static void RepaintAll() => Repainted++;
}
