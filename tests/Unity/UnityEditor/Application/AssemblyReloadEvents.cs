using UnityEngine.StandIn;

namespace UnityEditor;

public static class AssemblyReloadEvents
{
    public delegate void AssemblyReloadCallback();

    static AssemblyReloadEvents() => System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(EditorApplication).TypeHandle);

    public static event AssemblyReloadCallback? beforeAssemblyReload;

    public static event AssemblyReloadCallback? afterAssemblyReload;

    internal static void RaiseBefore() => Raise(beforeAssemblyReload);

    internal static void RaiseAfter() => Raise(afterAssemblyReload);

    internal static void Forget() => (beforeAssemblyReload, afterAssemblyReload) = (null, null);

    private static void Raise(AssemblyReloadCallback? handlers)
    {
        foreach (AssemblyReloadCallback handler in (handlers?.GetInvocationList() ?? []).Cast<AssemblyReloadCallback>())
            ScriptCallbacks.Run(() => handler(), null!);
    }
}
