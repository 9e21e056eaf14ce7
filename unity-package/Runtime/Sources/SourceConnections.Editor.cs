#if UNITY_EDITOR
#nullable enable

using UnityEditor;

namespace NeuronMocap.Unity
{
    // In the editor, the process continues after play mode ends or scripts are compiled. Threads and sockets that are not closed continue too.
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
