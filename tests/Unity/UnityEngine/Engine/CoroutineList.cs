using System.Collections;

namespace UnityEngine.StandIn;

/// <summary>The coroutines of one script.</summary>
internal sealed class CoroutineList(MonoBehaviour script)
{
    private readonly List<Coroutine> _running = [];

    public int Count => _running.Count;

    public Coroutine Start(IEnumerator routine)
    {
        var coroutine = new Coroutine(routine, script);
        _running.Add(coroutine);
        ScriptList.AddWaiting(script);
        coroutine.Advance();
        return coroutine;
    }

    public void Stop(IEnumerator routine)
    {
        foreach (Coroutine coroutine in _running.FindAll(item => ReferenceEquals(item.Routine, routine)))
            coroutine.Stop();
    }

    public void StopAll()
    {
        foreach (Coroutine coroutine in _running)
            coroutine.Stop();

        _running.Clear();
    }

    /// <summary>Continues the coroutines that wait for this moment of the frame.</summary>
    public void Run(FrameMoment moment)
    {
        if (_running.Count == 0)
            return;

        int count = _running.Count;
        for (int i = 0; i < count && i < _running.Count; i++)
        {
            if (_running[i].IsReady(moment))
                _running[i].Advance();
        }

        Sweep();
    }

    // Only here, because elsewhere a caller may be iterating the list.
    private void Sweep()
    {
        for (int i = _running.Count - 1; i >= 0; i--)
        {
            if (_running[i].IsDone)
                _running.RemoveAt(i);
        }
    }
}

/// <summary>Specifies the moments of a frame at which coroutines continue.</summary>
internal enum FrameMoment
{
    AfterFixedUpdate,
    AfterUpdate,
    EndOfFrame,
}
