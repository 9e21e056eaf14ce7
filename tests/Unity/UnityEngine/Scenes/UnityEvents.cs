namespace UnityEngine.Events;

public delegate void UnityAction();

public delegate void UnityAction<T0>(T0 arg0);

public delegate void UnityAction<T0, T1>(T0 arg0, T1 arg1);

[Serializable]
public abstract class UnityEventBase
{
    public abstract void RemoveAllListeners();
}

[Serializable]
public class UnityEvent : UnityEventBase
{
    private UnityAction? _listeners;

    public void AddListener(UnityAction call) => _listeners += call;

    public void RemoveListener(UnityAction call) => _listeners -= call;

    public void Invoke() => _listeners?.Invoke();

    public override void RemoveAllListeners() => _listeners = null;
}

[Serializable]
public class UnityEvent<T0> : UnityEventBase
{
    private UnityAction<T0>? _listeners;

    public void AddListener(UnityAction<T0> call) => _listeners += call;

    public void RemoveListener(UnityAction<T0> call) => _listeners -= call;

    public void Invoke(T0 arg0) => _listeners?.Invoke(arg0);

    public override void RemoveAllListeners() => _listeners = null;
}
