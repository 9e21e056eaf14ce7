namespace UnityEngine.StandIn;

/// <summary>The enabled scripts in the order in which they run: by execution order, then by the time when they were enabled.</summary>
internal static class ScriptList
{
    private static readonly List<MonoBehaviour> _scripts = [];
    private static readonly List<MonoBehaviour> _waiting = [];
    private static MonoBehaviour[] _phase = [];

    public static void Add(MonoBehaviour script)
    {
        int index = _scripts.Count;
        while (index > 0 && _scripts[index - 1].State.Order > script.State.Order)
            index--;

        _scripts.Insert(index, script);
    }

    public static void Remove(MonoBehaviour script) => _scripts.Remove(script);

    public static void Clear()
    {
        _scripts.Clear();
        _waiting.Clear();
    }

    /// <summary>Coroutines and delayed calls continue while their script is disabled, as long as its object is active.</summary>
    public static void AddWaiting(MonoBehaviour script)
    {
        if (!_waiting.Contains(script))
            _waiting.Add(script);
    }

    public static void RunCoroutines(FrameMoment moment)
    {
        int count = _waiting.Count;
        for (int i = 0; i < count; i++)
        {
            if (moment == FrameMoment.AfterUpdate)
                _waiting[i].State.Invocations.Run();

            _waiting[i].State.Coroutines.Run(moment);
        }

        for (int i = _waiting.Count - 1; i >= 0; i--)
        {
            if (_waiting[i].IsDestroyed || !_waiting[i].State.IsWaiting)
                _waiting.RemoveAt(i);
        }
    }

    /// <summary>Runs a step for each script. Scripts added in between wait for the next step; removed scripts are skipped.</summary>
    public static void ForEach(Action<MonoBehaviour> step)
    {
        int count = _scripts.Count;
        if (_phase.Length < count)
            _phase = new MonoBehaviour[count * 2];

        MonoBehaviour[] phase = _phase;
        _scripts.CopyTo(phase);
        for (int i = 0; i < count; i++)
        {
            MonoBehaviour script = phase[i];
            if (!script.IsDestroyed && script.State.IsEnabled)
                step(script);
        }

        Array.Clear(phase, 0, count);
    }
}
