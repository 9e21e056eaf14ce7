using UnityEngine.StandIn;

namespace UnityEditor;

public static class AssemblyReloadEvents
{
    static AssemblyReloadEvents() => PlayMode.Changed += static step =>
    {
        if (step == PlayModeStep.BeforeAssemblyReload)
            beforeAssemblyReload?.Invoke();
        else if (step == PlayModeStep.Forgotten)
            beforeAssemblyReload = null;
    };

    public delegate void AssemblyReloadCallback();

    public static event AssemblyReloadCallback? beforeAssemblyReload;
}
