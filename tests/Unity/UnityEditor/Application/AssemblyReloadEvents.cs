namespace UnityEditor;

public static class AssemblyReloadEvents
{
    public delegate void AssemblyReloadCallback();

    public static event AssemblyReloadCallback? beforeAssemblyReload;

    /// <summary>For tests: scripts were compiled.</summary>
    public static void RaiseBeforeAssemblyReload() => beforeAssemblyReload?.Invoke();
}
