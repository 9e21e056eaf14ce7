using System.Diagnostics;
using UnityEngine.SceneManagement;

namespace UnityEngine.StandIn;

/// <summary>
/// The engine's frames, run by a test, for one project with one scene. Everything happens on the calling thread, which becomes the main thread.
/// </summary>
internal sealed class PlayerLoop : IDisposable
{
    private static readonly Action<MonoBehaviour> _start = static script => script.State.Start();

    private static readonly Action<MonoBehaviour> _fixedUpdate = static script => Run(script, script.State.FixedUpdate);

    private static readonly Action<MonoBehaviour> _update = static script => Run(script, script.State.Update);

    private static readonly Action<MonoBehaviour> _lateUpdate = static script => Run(script, script.State.LateUpdate);

    private readonly UnitySynchronizationContext _context = new();
    private readonly Stopwatch _clock = Stopwatch.StartNew();
    private double _physics;
    private double _played;
    private TimeSpan _lastFrame;

    /// <summary>Creates a loop with an empty scene. A game that still plays ends first, as a person must end it to open another project.</summary>
    /// <param name="play">False to stay in edit mode.</param>
    public PlayerLoop(bool play = true)
    {
        MainThread.Claim();
        EndGame();
        Reset();
        PlayMode.Loop = this;
        PlayMode.Start(play);
    }

    /// <summary>Whether gizmos are drawn, as in the scene view, and for which selected object.</summary>
    public bool DrawsGizmos { get; set; }

    public GameObject? Selected { get; set; }

    /// <summary>Runs one frame.</summary>
    /// <param name="seconds">The duration of the previous frame.</param>
    public void Frame(float seconds = 1 / 60f)
    {
        MainThread.Claim();
        SynchronizationContext? outside = SynchronizationContext.Current;
        SynchronizationContext.SetSynchronizationContext(_context);
        try
        {
            Time.Advance(seconds);
            _played += Math.Min(seconds, Time.maximumDeltaTime);
            GizmoLog.Clear();
            if (SceneManager.Requested is { } scene)
                SceneManager.Change(scene, null);

            RunPhases();
        }
        finally
        {
            SynchronizationContext.SetSynchronizationContext(outside);
        }
    }

    public void Frames(int count, float seconds = 1 / 60f)
    {
        for (int i = 0; i < count; i++)
            Frame(seconds);
    }

    /// <summary>Runs frames in real time until a condition holds.</summary>
    /// <exception cref="TimeoutException">The condition does not hold after a minute.</exception>
    public void RunUntil(Func<bool> condition)
    {
        var limit = Stopwatch.StartNew();
        _lastFrame = _clock.Elapsed;
        while (!condition())
        {
            if (limit.Elapsed > TimeSpan.FromSeconds(60))
                throw new TimeoutException("What was waited for has not come after a minute of frames; see the log: " + string.Join("; ", ConsoleLog.Entries.Select(static entry => entry.Message)));

            Thread.Sleep(1);
            TimeSpan now = _clock.Elapsed;
            float seconds = (float)(now - _lastFrame).TotalSeconds;
            _lastFrame = now;
            Frame(seconds);
        }
    }

    /// <summary>
    /// Runs frames in real time until the game has played for a while, and at least one. On a busy machine, a frame may take longer than the whole
    /// while. The game plays its time only in the next frames, and no frame plays more than Unity's maximum.
    /// </summary>
    public void RunFor(float seconds)
    {
        double end = _played + seconds;
        int checks = 0;
        RunUntil(() => checks++ > 0 && _played >= end);
    }

    /// <summary>Changes to another scene.</summary>
    /// <param name="name">The name of the other scene.</param>
    /// <param name="build">Creates the content of the other scene.</param>
    public void ChangeScene(string name = "Next", Action? build = null) => SceneManager.Change(name, build);

    /// <summary>Changes from edit mode to play mode, as the editor does.</summary>
    public void EnterPlayMode(bool reloadDomain = true) => PlayMode.Enter(reloadDomain);

    /// <summary>Changes from play mode to edit mode: objects are disabled and destroyed, and the scene is restored.</summary>
    public void ExitPlayMode() => PlayMode.Exit();

    /// <summary>Reloads scripts as if they were compiled while the game runs: disabled, statics reset, enabled again.</summary>
    public void ReloadDomain() => PlayMode.Reload();

    /// <summary>Moves the application to the foreground or background.</summary>
    public void Focus(bool isFocused)
    {
        Application.RaiseFocus(isFocused);
        foreach (MonoBehaviour script in World.Objects.OfType<MonoBehaviour>().Where(static item => item.State.IsEnabled).ToArray())
            script.SendMessage(isFocused ? "OnApplicationFocus" : "OnApplicationPause");
    }

    /// <summary>Creates an asset. Its objects are in no scene and its scripts do not run, but those of copies do.</summary>
    public GameObject CreatePrefab(string name, Action<GameObject>? build = null)
    {
        World.IsMakingAsset = true;
        try
        {
            var prefab = new GameObject(name);
            build?.Invoke(prefab);
            return prefab;
        }
        finally
        {
            World.IsMakingAsset = false;
        }
    }

    public void Dispose()
    {
        MainThread.Claim();
        EndGame();
        Reset();
        PlayMode.Loop = null;
    }

    private static void EndGame()
    {
        if (World.IsPlaying)
            PlayMode.Exit();
    }

    private static void Reset()
    {
        World.Clear();
        ScriptList.Clear();
        PhysicsStep.Clear();
        PlayMode.ForgetListeners();
        ConsoleLog.Clear();
        GizmoLog.Clear();
        Input.Clear();
        CharacterController.Clear();
        Resources.Assets.Clear();
        Time.Restart();
        HumanPoseHandler.BodyIsInWorld = false;
    }

    private static void Run(MonoBehaviour script, Action? callback)
    {
        if (callback is null)
            return;

        // A script enabled in mid-frame starts before its first step.
        script.State.Start();
        if (script.State.IsEnabled)
            ScriptCallbacks.Run(callback, script);
    }

    private void RunPhases()
    {
        ScriptList.ForEach(_start);
        for (_physics += Time.deltaTime; World.IsPlaying && _physics >= Time.fixedDeltaTime; _physics -= Time.fixedDeltaTime)
        {
            Time.BeginFixedStep();
            ScriptList.ForEach(_fixedUpdate);
            Animator.RunAll(inPhysics: true);
            PhysicsStep.Run(Time.fixedDeltaTime);
            ScriptList.RunCoroutines(FrameMoment.AfterFixedUpdate);
            Time.EndFixedStep();
        }

        _context.Run();
        ScriptList.ForEach(_update);
        ScriptList.RunCoroutines(FrameMoment.AfterUpdate);
        Animator.RunAll(inPhysics: false);
        ScriptList.ForEach(_lateUpdate);
        if (DrawsGizmos)
            GizmoDrawing.Draw(Selected);

        ScriptList.RunCoroutines(FrameMoment.EndOfFrame);
        World.DestroyDue(Time.time);
        Input.EndFrame();
        PlayMode.Follow();
    }
}
