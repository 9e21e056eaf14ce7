using System.Collections;

namespace UnityEngine.StandIn;

/// <summary>The current stage of a script's life, and its running coroutines and calls.</summary>
internal sealed class ScriptState
{
    private readonly MonoBehaviour _script;
    private readonly ScriptCallbacks _callbacks;
    private bool _isAwake;
    private bool _isEnabled;
    private bool _isStarted;

    public ScriptState(MonoBehaviour script)
    {
        _script = script;
        _callbacks = ScriptCallbacks.Of(script.GetType());
        FixedUpdate = _callbacks.Bind(script, "FixedUpdate");
        Update = _callbacks.Bind(script, "Update");
        LateUpdate = _callbacks.Bind(script, "LateUpdate");
        Coroutines = new CoroutineList(script);
        Invocations = new InvocationList(script);
    }

    public Action? FixedUpdate { get; }

    public Action? Update { get; }

    public Action? LateUpdate { get; }

    public CoroutineList Coroutines { get; }

    public InvocationList Invocations { get; }

    public int Order => _callbacks.Order;

    public bool IsAwake => _isAwake;

    public bool IsEnabled => _isEnabled;

    public bool IsWaiting => Coroutines.Count > 0 || Invocations.Count > 0;

    private bool MayRun => World.IsPlaying || _callbacks.RunsInEditMode || _script.runInEditMode;

    /// <summary>Calls Awake, OnEnable or OnDisable after a change of activity.</summary>
    public void Refresh()
    {
        if (_script.IsDestroyed || _script.Owner is not { } owner)
            return;

        if (owner.IsActive && MayRun && !_isAwake)
        {
            _isAwake = true;
            if (!_callbacks.Call(_script, "Awake"))
                _script.enabled = false;
        }

        bool isRunning = _script.IsRunning && MayRun;
        if (isRunning && !_isEnabled)
        {
            _isEnabled = true;
            ScriptList.Add(_script);
            _callbacks.Call(_script, "OnEnable");
        }
        else if (!isRunning && _isEnabled)
        {
            Disable();
        }

        if (!owner.IsActive)
        {
            Coroutines.StopAll();
            Invocations.Clear();
        }
    }

    public void Start()
    {
        if (_isStarted || !_isEnabled)
            return;

        _isStarted = true;
        if (_callbacks.Find("Start") is not { } method)
            return;

        if (method.ReturnType == typeof(void))
            _callbacks.Call(_script, "Start");
        else if (method.Invoke(_script, null) is IEnumerator routine)
            Coroutines.Start(routine);
    }

    public void Disable()
    {
        if (!_isEnabled)
            return;

        _isEnabled = false;
        ScriptList.Remove(_script);
        _callbacks.Call(_script, "OnDisable");
    }

    public void Call(string name) => _callbacks.Call(_script, name);

    public void End()
    {
        Disable();
        Coroutines.StopAll();
        Invocations.Clear();
        if (_isAwake)
            _callbacks.Call(_script, "OnDestroy");
    }
}
