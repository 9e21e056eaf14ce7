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
    /// Keeps scripts written for the vendor's C# functions from outliving their program: what they left open is closed when play mode is left, before
    /// scripts are reloaded and when the application quits, whether or not the domain is reloaded. Exceptions of their callbacks go to the console.
    /// Nothing has to be added to a scene.
    /// </summary>
    internal static class ScriptSession
    {
        // The main thread waits for no callback longer than that; a callback that waits for the main thread would hold it up for ever.
        private static readonly TimeSpan CloseTimeout = TimeSpan.FromMilliseconds(50);
        private static readonly TimeSpan LogPause = TimeSpan.FromSeconds(10);

        private static readonly object LogLock = new object();
        private static readonly Stopwatch SinceLog = new Stopwatch();

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Begin()
        {
            // Without a domain reload these are still there from the last time.
            Application.quitting -= End;
            Application.quitting += End;
            CompatibilityEvents.CallbackFailed -= LogFailure;
            CompatibilityEvents.CallbackFailed += LogFailure;
        }

        private static void End() => VendorSession.End(CloseTimeout);

        // On the receive thread, as often as frames come.
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

        // When play mode is about to end, so that no frame reaches what is being destroyed; and when it has ended, as a script may have connected again
        // meanwhile.
        private static void EndPlayMode(PlayModeStateChange change)
        {
            if (change == PlayModeStateChange.ExitingPlayMode || change == PlayModeStateChange.EnteredEditMode)
                End();
        }
#endif
    }
}
