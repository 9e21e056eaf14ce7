#nullable enable

using System;
using System.Diagnostics;
using NeuronMocap.Compatibility;
using UnityEngine;
#if UNITY_EDITOR
using UnityEditor;
#endif

namespace NeuronMocap.Unity.Compatibility
{
    /// <summary>
    /// Closes the connections of scripts written for the vendor's C# functions, so that the connections do not outlive the program. It closes them
    /// when play mode ends, before scripts are reloaded, and when the application quits, with or without a domain reload. Exceptions of callbacks go
    /// to the console. Scenes need no change.
    /// </summary>
    internal static class ScriptSession
    {
        // The main thread waits no longer than this for a callback. A callback that waits for the main thread would otherwise block it forever.
        private static readonly TimeSpan CloseTimeout = TimeSpan.FromMilliseconds(50);
        private static readonly TimeSpan LogPause = TimeSpan.FromSeconds(10);

        private static readonly object LogLock = new object();
        private static readonly Stopwatch SinceLog = new Stopwatch();

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Begin()
        {
            // Without a domain reload, handlers of the last session are still attached.
            Application.quitting -= End;
            Application.quitting += End;
            CompatibilityEvents.CallbackFailed -= LogFailure;
            CompatibilityEvents.CallbackFailed += LogFailure;
        }

        private static void End() => VendorSession.End(CloseTimeout);

        // Runs on the receive thread, possibly for every frame.
        private static void LogFailure(Exception exception)
        {
            lock (LogLock)
            {
                if (SinceLog.IsRunning && SinceLog.Elapsed < LogPause)
                    return;

                SinceLog.Restart();
            }

            UnityEngine.Debug.LogException(exception);
        }

#if UNITY_EDITOR
        [InitializeOnLoadMethod]
        private static void BeginInEditor()
        {
            AssemblyReloadEvents.beforeAssemblyReload += End;
            EditorApplication.playModeStateChanged += EndPlayMode;
        }

        // Closes when play mode is about to end, so that no frame reaches objects that are being destroyed. Closes again when it has ended, because a
        // script may have reconnected in between.
        private static void EndPlayMode(PlayModeStateChange change)
        {
            if (change == PlayModeStateChange.ExitingPlayMode || change == PlayModeStateChange.EnteredEditMode)
                End();
        }
#endif
    }
}
