using System.Reflection;
using UnityEngine.SceneManagement;

namespace UnityEngine.StandIn;

/// <summary>Enters and leaves play mode, and reloads scripts, in the editor's order of steps.</summary>
internal static class PlayMode
{
    private static readonly List<GameObject> _backup = [];

    /// <summary>Notifies the editor's stand-in of the steps.</summary>
    public static event Action<PlayModeStep>? Changed;

    public static PlayerLoop? Loop { get; set; }

    /// <summary>The state requested by an editor script. It takes effect at the end of the frame.</summary>
    public static bool? RequestedState { get; set; }

    public static void Follow()
    {
        if (RequestedState is not { } isPlaying)
            return;

        RequestedState = null;
        if (isPlaying && !World.IsPlaying)
            Enter(reloadDomain: true);
        else if (!isPlaying && World.IsPlaying)
            Exit();
    }

    /// <summary>Starts a new project, with scripts that have just been loaded.</summary>
    public static void Start(bool play)
    {
        ScriptStatics.Reset();
        Raise(PlayModeStep.Loaded);
        if (play)
            Enter(reloadDomain: false);
    }

    public static void Enter(bool reloadDomain)
    {
        if (World.IsPlaying)
            throw new InvalidOperationException("Playing already.");

        Raise(PlayModeStep.ExitingEditMode);
        BackUp();
        if (reloadDomain)
            ReloadStatics();

        World.IsPlaying = true;
        foreach (RuntimeInitializeLoadType moment in (RuntimeInitializeLoadType[])
            [RuntimeInitializeLoadType.SubsystemRegistration, RuntimeInitializeLoadType.AfterAssembliesLoaded, RuntimeInitializeLoadType.BeforeSplashScreen, RuntimeInitializeLoadType.BeforeSceneLoad])
        {
            Initialize(moment);
        }

        Cloning.Wake(World.Objects.OfType<MonoBehaviour>());
        Initialize(RuntimeInitializeLoadType.AfterSceneLoad);
        Raise(PlayModeStep.EnteredPlayMode);
    }

    public static void Exit()
    {
        Raise(PlayModeStep.ExitingPlayMode);
        foreach (MonoBehaviour script in World.Objects.OfType<MonoBehaviour>().Where(static item => item.State.IsEnabled).ToArray())
            script.State.Call("OnApplicationQuit");

        Application.RaiseQuitting();
        foreach (GameObject root in World.GetRoots().ToArray())
        {
            if (!root.IsDestroyed)
                root.DestroyNow();
        }

        World.IsPlaying = false;
        Restore();
        Raise(PlayModeStep.EnteredEditMode);
    }

    public static void Reload()
    {
        MonoBehaviour[] scripts = [.. World.Objects.OfType<MonoBehaviour>().Where(static item => item.State.IsAwake)];
        Raise(PlayModeStep.BeforeAssemblyReload);
        foreach (MonoBehaviour script in scripts)
            script.State.Disable();

        ReloadStatics(raise: false);
        foreach (MonoBehaviour script in scripts)
        {
            script.StopAllCoroutines();
            ReloadedScript.Renew(script);
        }

        Cloning.Wake(scripts);

        Raise(PlayModeStep.AfterAssemblyReload);
    }

    public static void ForgetListeners()
    {
        Changed?.Invoke(PlayModeStep.Forgotten);
        Application.ForgetListeners();
        SceneManager.ForgetListeners();
        foreach (GameObject item in _backup)
            item.MarkDestroyed();

        _backup.Clear();
    }

    private static void ReloadStatics(bool raise = true)
    {
        if (raise)
            Raise(PlayModeStep.BeforeAssemblyReload);

        Changed?.Invoke(PlayModeStep.Forgotten);
        Application.ForgetListeners();
        ScriptStatics.Reset();
        Raise(PlayModeStep.Loaded);
        if (raise)
            Raise(PlayModeStep.AfterAssemblyReload);
    }

    private static void Initialize(RuntimeInitializeLoadType moment)
    {
        foreach (MethodInfo method in ScriptStatics.GetInitializers(moment))
            ScriptCallbacks.Run((Action)Delegate.CreateDelegate(typeof(Action), method), null!);
    }

    private static void Raise(PlayModeStep step) => Changed?.Invoke(step);

    // Keeps the scene as assets, and restores it from them.
    private static void BackUp()
    {
        _backup.Clear();
        World.IsMakingAsset = true;
        try
        {
            foreach (GameObject root in World.GetRoots().ToArray())
            {
                GameObject copy = Object.Instantiate(root);
                copy.name = root.name;
                _backup.Add(copy);
            }
        }
        finally
        {
            World.IsMakingAsset = false;
        }
    }

    private static void Restore()
    {
        foreach (GameObject item in _backup)
        {
            Cloning.Clone(item, null, copy => copy.name = item.name);
            item.DestroyNow();
        }

        _backup.Clear();
    }
}

internal enum PlayModeStep
{
    ExitingEditMode,
    EnteredPlayMode,
    ExitingPlayMode,
    EnteredEditMode,
    BeforeAssemblyReload,
    AfterAssemblyReload,

    /// <summary>All handlers are removed, like the scripts that registered them.</summary>
    Forgotten,

    /// <summary>The new scripts are loaded: [InitializeOnLoad] runs.</summary>
    Loaded,
}
