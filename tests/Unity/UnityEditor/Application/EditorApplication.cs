using UnityEngine.StandIn;

namespace UnityEditor;

public static class EditorApplication
{
    private static double _time;

    static EditorApplication() => PlayMode.Changed += OnStep;

    public delegate void CallbackFunction();

    public static event Action<PlayModeStateChange>? playModeStateChanged;

    public static event Action? hierarchyChanged;

    // A field in Unity; used in the same way.
    public static event CallbackFunction? update;

    public static double timeSinceStartup => _time;

    public static bool isPlaying => World.IsPlaying;

    /// <summary>The hierarchy has changed.</summary>
    internal static void RaiseHierarchyChanged() => hierarchyChanged?.Invoke();

    /// <summary>The editor's own loop goes round once.</summary>
    internal static void Tick(double seconds)
    {
        _time += seconds;
        update?.Invoke();
    }

    private static void OnStep(PlayModeStep step)
    {
        switch (step)
        {
            case PlayModeStep.ExitingEditMode:
                playModeStateChanged?.Invoke(PlayModeStateChange.ExitingEditMode);
                break;
            case PlayModeStep.EnteredPlayMode:
                playModeStateChanged?.Invoke(PlayModeStateChange.EnteredPlayMode);
                break;
            case PlayModeStep.ExitingPlayMode:
                playModeStateChanged?.Invoke(PlayModeStateChange.ExitingPlayMode);
                break;
            case PlayModeStep.EnteredEditMode:
                playModeStateChanged?.Invoke(PlayModeStateChange.EnteredEditMode);
                break;
            case PlayModeStep.Forgotten:
                (playModeStateChanged, hierarchyChanged, update) = (null, null, null);
                break;
        }
    }
}
