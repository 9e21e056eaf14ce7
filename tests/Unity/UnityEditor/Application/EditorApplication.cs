namespace UnityEditor;

public static class EditorApplication
{
    public delegate void CallbackFunction();

    public static event Action<PlayModeStateChange>? playModeStateChanged;

    public static event Action? hierarchyChanged;

    // A field in Unity, too.
    public static CallbackFunction? update;

    public static double timeSinceStartup { get; set; }

    public static bool isPlaying { get; set; }

    /// <summary>For tests: the hierarchy has changed.</summary>
    public static void RaiseHierarchyChanged() => hierarchyChanged?.Invoke();

    /// <summary>For tests: play mode begins or ends.</summary>
    public static void RaisePlayModeStateChanged(PlayModeStateChange change) => playModeStateChanged?.Invoke(change);

    /// <summary>For tests: the editor's own loop goes round once.</summary>
    public static void Tick(double seconds)
    {
        timeSinceStartup += seconds;
        update?.Invoke();
    }
}
