#if UNITY_EDITOR
#nullable enable

using UnityEditor;

namespace NeuronMocap.Unity
{
    // In the editor the process lives on when play mode ends or scripts are compiled, and with it every thread and socket that nobody closes.
    internal static partial class SourceConnections
    {
        [InitializeOnLoadMethod]
        private static void Watch()
        {
            AssemblyReloadEvents.beforeAssemblyReload -= CloseAll;
            AssemblyReloadEvents.beforeAssemblyReload += CloseAll;
            EditorApplication.playModeStateChanged -= OnPlayModeChanged;
            EditorApplication.playModeStateChanged += OnPlayModeChanged;
        }

        private static void OnPlayModeChanged(PlayModeStateChange change)
        {
            if (change is PlayModeStateChange.ExitingPlayMode or PlayModeStateChange.EnteredEditMode)
                CloseAll();
        }
    }
}
#endif
