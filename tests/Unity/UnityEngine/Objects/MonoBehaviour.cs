using System.Collections;
using UnityEngine.StandIn;

namespace UnityEngine;

public class MonoBehaviour : Behaviour
{
    private ScriptState? _state;

    public bool useGUILayout { get; set; } = true;

    public bool runInEditMode { get; set; }

    internal ScriptState State => _state ??= new ScriptState(this);

    public static void print(object message) => Debug.Log(message);

    public Coroutine? StartCoroutine(IEnumerator routine)
    {
        Check();
        if (gameObject.activeInHierarchy)
            return State.Coroutines.Start(routine);

        Debug.LogError($"Coroutine couldn't be started because the the game object '{name}' is inactive!");
        return null;
    }

    public Coroutine? StartCoroutine(string methodName) =>
        ScriptCallbacks.Of(GetType()).Find(methodName)?.Invoke(this, null) is IEnumerator routine ? StartCoroutine(routine) : null;

    public void StopCoroutine(IEnumerator routine) => State.Coroutines.Stop(routine);

    public void StopCoroutine(Coroutine routine) => routine.Stop();

    public void StopAllCoroutines() => State.Coroutines.StopAll();

    public void Invoke(string methodName, float time) => State.Invocations.Add(methodName, time, 0);

    public void InvokeRepeating(string methodName, float time, float repeatRate) => State.Invocations.Add(methodName, time, repeatRate);

    public void CancelInvoke() => State.Invocations.Clear();

    public void CancelInvoke(string methodName) => State.Invocations.Remove(methodName);

    public bool IsInvoking(string methodName) => State.Invocations.Contains(methodName);

    internal override void RefreshActivity() => State.Refresh();

    internal override void DestroyNow()
    {
        State.End();
        base.DestroyNow();
    }
}
