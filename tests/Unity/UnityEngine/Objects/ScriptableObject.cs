namespace UnityEngine;

public class ScriptableObject : Object
{
    public static T CreateInstance<T>()
        where T : ScriptableObject => (T)CreateInstance(typeof(T));

    public static ScriptableObject CreateInstance(Type type)
    {
        var created = (ScriptableObject)Activator.CreateInstance(type)!;
        StandIn.ScriptCallbacks.Of(type).Call(created, "Awake");
        StandIn.ScriptCallbacks.Of(type).Call(created, "OnEnable");
        return created;
    }

    internal override void DestroyNow()
    {
        StandIn.ScriptCallbacks.Of(GetType()).Call(this, "OnDisable");
        StandIn.ScriptCallbacks.Of(GetType()).Call(this, "OnDestroy");
        base.DestroyNow();
    }
}
