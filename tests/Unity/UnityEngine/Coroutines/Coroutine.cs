using System.Collections;
using UnityEngine.StandIn;

namespace UnityEngine;

public sealed class Coroutine : YieldInstruction
{
    private readonly MonoBehaviour _script;
    private readonly Stack<IEnumerator> _nested = new();
    private object? _awaited;
    private float _until;
    private int _frame;
    private Coroutine? _continuation;

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
        Coroutine => false,
        _ when moment != FrameMoment.AfterUpdate || Time.frameCount == _frame => false,
        WaitForSeconds => Time.time >= _until,
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
                // It stopped itself in the meantime, so nothing is left to leave.
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
                _frame = Time.frameCount;
                if (_awaited is not Coroutine { IsDone: true })
                {
                    if (_awaited is Coroutine other)
                        other._continuation = this;

                    return;
                }
            }
        }

        _continuation?.Advance();
    }
}
