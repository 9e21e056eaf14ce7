using System.Collections;

namespace UnityEngine;

public class YieldInstruction
{
}

public sealed class WaitForSeconds(float seconds) : YieldInstruction
{
    internal float Seconds { get; } = seconds;
}

public sealed class WaitForEndOfFrame : YieldInstruction
{
}

public sealed class WaitForFixedUpdate : YieldInstruction
{
}

public class AsyncOperation : YieldInstruction
{
    public event Action<AsyncOperation>? completed;

    public bool isDone { get; private set; }

    public float progress => isDone ? 1 : 0;

    public bool allowSceneActivation { get; set; } = true;

    internal void Complete()
    {
        isDone = true;
        completed?.Invoke(this);
    }
}

public abstract class CustomYieldInstruction : IEnumerator
{
    public abstract bool keepWaiting { get; }

    public object? Current => null;

    public bool MoveNext() => keepWaiting;

    public virtual void Reset()
    {
    }
}

public sealed class WaitUntil(Func<bool> predicate) : CustomYieldInstruction
{
    public override bool keepWaiting => !predicate();
}

public sealed class WaitWhile(Func<bool> predicate) : CustomYieldInstruction
{
    public override bool keepWaiting => predicate();
}

public class WaitForSecondsRealtime(float time) : CustomYieldInstruction
{
    private float _until = -1;

    public float waitTime { get; set; } = time;

    public override bool keepWaiting
    {
        get
        {
            if (_until < 0)
                _until = Time.realtimeSinceStartup + waitTime;

            return Time.realtimeSinceStartup < _until;
        }
    }
}
