#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.EditorTools
{
    // Lets sources move their figures without play mode. Every figure returns to its pose in the scene before anything could save or replace that
    // pose. Copies of a figure made meanwhile keep the pose of the preview. AnimationMode would do the same, but only for one window at a time, and Timeline needs it.
    internal static class LivePreview
    {
        private static readonly List<MocapSource> Sources = new List<MocapSource>();
        private static FigureDriver[] _figures = Array.Empty<FigureDriver>();

        public static bool IsOn => Sources.Count > 0;

        public static bool Includes(MocapSource source) => Sources.Contains(source);

        // Assets and disabled components have no preview.
        public static bool CanStart(MocapSource source) =>
            !EditorApplication.isPlayingOrWillChangePlaymode && OpenScenes.Contains(source) && source.isActiveAndEnabled;

        public static void Start(MocapSource source)
        {
            if (Includes(source) || !CanStart(source))
                return;

            if (!IsOn)
                Watch();

            Sources.Add(source);
            source.BeginPreview();
        }

        // Other sources go on with the next update.
        public static void Stop(MocapSource source)
        {
            if (!Sources.Remove(source))
                return;

            Array.ForEach(_figures, figure => figure.EndPreview());
            source.EndPreview();
            if (!IsOn)
                Unwatch();

            SceneView.RepaintAll();
        }

        public static void StopAll()
        {
            while (IsOn)
                Stop(Sources[Sources.Count - 1]);
        }

        private static void Watch()
        {
            EditorApplication.update += Update;
            EditorApplication.hierarchyChanged += FindFigures;
            EditorApplication.playModeStateChanged += OnPlayModeChanged;
            EditorApplication.quitting += StopAll;
            AssemblyReloadEvents.beforeAssemblyReload += StopAll;
            EditorSceneManager.sceneSaving += OnSceneSaving;
            EditorSceneManager.sceneClosing += OnSceneClosing;
            PrefabStage.prefabSaving += OnPrefabSaving;
            FindFigures();
        }

        private static void Unwatch()
        {
            EditorApplication.update -= Update;
            EditorApplication.hierarchyChanged -= FindFigures;
            EditorApplication.playModeStateChanged -= OnPlayModeChanged;
            EditorApplication.quitting -= StopAll;
            AssemblyReloadEvents.beforeAssemblyReload -= StopAll;
            EditorSceneManager.sceneSaving -= OnSceneSaving;
            EditorSceneManager.sceneClosing -= OnSceneClosing;
            PrefabStage.prefabSaving -= OnPrefabSaving;
            _figures = Array.Empty<FigureDriver>();
        }

        private static void Update()
        {
            for (int i = Sources.Count - 1; i >= 0; i--)
            {
                MocapSource source = Sources[i];
                if (source == null || !source.isActiveAndEnabled)
                    Stop(source!);
                else
                    source.Preview();
            }

            if (!IsOn)
                return;

            foreach (FigureDriver figure in _figures)
            {
                bool follows = figure != null && figure.isActiveAndEnabled && (figure.Source == null || Includes(figure.Source));
                if (follows)
                    figure!.Preview();
                else
                    figure!.EndPreview();
            }

            EditorApplication.QueuePlayerLoopUpdate();
            SceneView.RepaintAll();
        }

        private static void FindFigures()
        {
            foreach (FigureDriver gone in _figures.Where(figure => figure == null))
                gone.EndPreview();

            _figures = Resources.FindObjectsOfTypeAll<FigureDriver>().Where(OpenScenes.Contains).ToArray();
        }

        private static void OnPlayModeChanged(PlayModeStateChange change) => StopAll();

        private static void OnSceneSaving(Scene scene, string path) => StopAll();

        private static void OnSceneClosing(Scene scene, bool isRemoved) => StopAll();

        private static void OnPrefabSaving(GameObject prefab) => StopAll();
    }
}
