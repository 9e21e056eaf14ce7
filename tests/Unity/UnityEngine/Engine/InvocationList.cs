namespace UnityEngine.StandIn;

/// <summary>The calls delayed by <see cref="MonoBehaviour.Invoke"/>.</summary>
internal sealed class InvocationList(MonoBehaviour script)
{
    private readonly List<(string Method, float Time, float Interval)> _pending = [];

    public int Count => _pending.Count;

    public void Add(string method, float delay, float interval)
    {
        _pending.Add((method, Time.time + delay, interval));
        ScriptList.AddWaiting(script);
    }

    public void Remove(string method) => _pending.RemoveAll(item => item.Method == method);

    public bool Contains(string method) => _pending.Exists(item => item.Method == method);

    public void Clear() => _pending.Clear();

    public void Run()
    {
        for (int i = 0; i < _pending.Count; i++)
        {
            (string method, float time, float interval) = _pending[i];
            if (time > Time.time)
                continue;

            if (interval > 0)
                _pending[i] = (method, time + interval, interval);
            else
                _pending.RemoveAt(i--);

            script.State.Call(method);
        }
    }
}
