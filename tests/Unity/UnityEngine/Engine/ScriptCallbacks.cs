using System.Reflection;

namespace UnityEngine.StandIn;

/// <summary>The methods of a script type that the engine calls by name, including private methods and those of base types.</summary>
internal sealed class ScriptCallbacks
{
    private static readonly Dictionary<Type, ScriptCallbacks> _known = [];

    private readonly Dictionary<string, MethodInfo?> _methods = [];
    private readonly Type _type;

    private ScriptCallbacks(Type type)
    {
        _type = type;
        Order = ComponentRules.GetOrder(type);
        RunsInEditMode = ComponentRules.RunsInEditMode(type);
    }

    public int Order { get; }

    public bool RunsInEditMode { get; }

    public static ScriptCallbacks Of(Type type)
    {
        if (!_known.TryGetValue(type, out ScriptCallbacks? callbacks))
            _known.Add(type, callbacks = new ScriptCallbacks(type));

        return callbacks;
    }

    public MethodInfo? Find(string name)
    {
        if (_methods.TryGetValue(name, out MethodInfo? method))
            return method;

        for (Type? type = _type; type is not null && method is null; type = type.BaseType)
            method = type.GetMethod(name, BindingFlags.DeclaredOnly | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic, null, [], null);

        _methods.Add(name, method);
        return method;
    }

    /// <summary>Creates a delegate, so that calling it every frame allocates nothing.</summary>
    public Action? Bind(object target, string name) =>
        Find(name) is { } method && method.ReturnType == typeof(void) ? (Action)Delegate.CreateDelegate(typeof(Action), target, method) : null;

    /// <returns>False if it threw an exception, which is in the log.</returns>
    public bool Call(Object target, string name)
    {
        Action? callback = Bind(target, name);
        if (callback is null)
            return true;

        return Run(callback, target);
    }

    public static bool Run(Action callback, Object target)
    {
#pragma warning disable CA1031 // As the engine does: whatever a script throws is logged, and the frame goes on.
        try
        {
            callback();
            return true;
        }
        catch (Exception exception)
        {
            Debug.LogException(exception, target);
            return false;
        }
#pragma warning restore CA1031
    }
}
