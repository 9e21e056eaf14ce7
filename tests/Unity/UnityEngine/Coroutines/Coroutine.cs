using System.Collections;
using UnityEngine.StandIn;

namespace UnityEngine;

public sealed class Coroutine : YieldInstruction
{
    private readonly MonoBehaviour _script;
    private readonly Stack<IEnumerator> _nested = new();
    private object? _awaited;
    private float _until;

    internal Coroutine(IEnumerator routine, MonoBehaviour script)
    {
        Routine = routine;
        _script = script;
        _nested.Push(routine);
    }

    internal IEnumerator Routine { get; }

    internal bool IsDone => _nested.Count == 0;

    internal void Stop() => _nested.Clear();

    internal bool IsReady(FrameMoment moment) => !IsDone && _awaited switch
    {
        WaitForEndOfFrame => moment == FrameMoment.EndOfFrame,
        WaitForFixedUpdate => moment == FrameMoment.AfterFixedUpdate,
        _ when moment != FrameMoment.AfterUpdate => false,
        WaitForSeconds => Time.time >= _until,
        Coroutine other => other.IsDone,
        AsyncOperation operation => operation.isDone,
        CustomYieldInstruction custom => !custom.keepWaiting,
        _ => true,
    };

    internal void Advance()
    {
        while (_nested.Count > 0)
        {
            bool isMore = false;
            IEnumerator current = _nested.Peek();
            if (!ScriptCallbacks.Run(() => isMore = current.MoveNext(), _script))
            {
                Stop();
                return;
            }

            if (!isMore)
            {
                // Stopped by itself meanwhile: nothing is left to leave.
                if (_nested.Count > 0)
                    _nested.Pop();
            }
            else if (current.Current is IEnumerator inner and not CustomYieldInstruction)
            {
                _nested.Push(inner);
            }
            else
            {
                _awaited = current.Current;
                _until = Time.time + (_awaited is WaitForSeconds wait ? wait.Seconds : 0);
                return;
            }
        }
    }
}
