using System.Reflection;
using UnityEngine.StandIn;

namespace UnityEditor;

public class EditorApplication
{
    public delegate void CallbackFunction();

    public static CallbackFunction? update;
    public static CallbackFunction? delayCall;

    private static double _time;

    static EditorApplication() => PlayMode.Changed += Follow;

    public static event Action<PlayModeStateChange>? playModeStateChanged;

    public static event Action<PauseState>? pauseStateChanged;

    public static event Action? hierarchyChanged;

    public static event Action? projectChanged;

    public static event Action? quitting;

    public static bool isPlaying
    {
        get => World.IsPlaying;
        set => PlayMode.RequestedState = value;
    }

    public static bool isPaused { get; set; }

    public static bool isCompiling { get; internal set; }

    public static bool isUpdating => false;

    public static bool isPlayingOrWillChangePlaymode { get; private set; }

    public static double timeSinceStartup => _time;

    public static void EnterPlaymode() => isPlaying = true;

    public static void ExitPlaymode() => isPlaying = false;

    public static void RepaintHierarchyWindow()
    {
    }

    public static void QueuePlayerLoopUpdate()
    {
    }

    public static bool ExecuteMenuItem(string menuItemPath) => MenuItems.Execute(menuItemPath);

    /// <summary>Runs one turn of the editor's own loop: delayed calls, then update.</summary>
    internal static void Tick(double seconds)
    {
        _time += seconds;
        CallbackFunction? delayed = delayCall;
        delayCall = null;
        delayed?.Invoke();
        update?.Invoke();
    }

    internal static void RaiseHierarchyChanged() => hierarchyChanged?.Invoke();

    internal static void RaisePause(bool isPaused)
    {
        EditorApplication.isPaused = isPaused;
        pauseStateChanged?.Invoke(isPaused ? PauseState.Paused : PauseState.Unpaused);
    }

    internal static void RaiseQuitting()
    {
        quitting?.Invoke();
        projectChanged?.Invoke();
    }

    private static void Follow(PlayModeStep step)
    {
        switch (step)
        {
            case PlayModeStep.ExitingEditMode:
                isPlayingOrWillChangePlaymode = true;
                Raise(PlayModeStateChange.ExitingEditMode);
                break;
            case PlayModeStep.EnteredPlayMode:
                Raise(PlayModeStateChange.EnteredPlayMode);
                break;
            case PlayModeStep.ExitingPlayMode:
                isPlayingOrWillChangePlaymode = false;
                Raise(PlayModeStateChange.ExitingPlayMode);
                break;
            case PlayModeStep.EnteredEditMode:
                Raise(PlayModeStateChange.EnteredEditMode);
                break;
            case PlayModeStep.BeforeAssemblyReload:
                AssemblyReloadEvents.RaiseBefore();
                break;
            case PlayModeStep.AfterAssemblyReload:
                AssemblyReloadEvents.RaiseAfter();
                break;
            case PlayModeStep.Forgotten:
                Forget();
                break;
            case PlayModeStep.Loaded:
                InitializeOnLoad();
                break;
        }
    }

    private static void Raise(PlayModeStateChange change)
    {
        foreach (Action<PlayModeStateChange> handler in (playModeStateChanged?.GetInvocationList() ?? []).Cast<Action<PlayModeStateChange>>())
            ScriptCallbacks.Run(() => handler(change), null!);
    }

    private static void Forget()
    {
        (update, delayCall, playModeStateChanged, pauseStateChanged) = (null, null, null, null);
        (hierarchyChanged, projectChanged, quitting) = (null, null, null);
        AssemblyReloadEvents.Forget();
        SceneManagement.EditorSceneManager.Forget();
        SceneManagement.PrefabStage.Forget();
        Undo.ClearAll();
        Selection.Forget();
        PrefabUtility.Forget();
    }

    /// <summary>Runs the code that the editor runs when it starts and after each reload of scripts.</summary>
    internal static void InitializeOnLoad()
    {
        foreach (Type type in ScriptStatics.Assemblies.SelectMany(static assembly => assembly.GetTypes()))
        {
            // A reload has already run the static initialisers. The first start has not.
            if (type.IsDefined(typeof(InitializeOnLoadAttribute), inherit: false))
                System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(type.TypeHandle);

            foreach (MethodInfo method in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
            {
                if (method.IsDefined(typeof(InitializeOnLoadMethodAttribute), inherit: false))
                    ScriptCallbacks.Run((Action)Delegate.CreateDelegate(typeof(Action), method), null!);
            }
        }
    }
}

public enum PauseState
{
    Paused,
    Unpaused,
}
