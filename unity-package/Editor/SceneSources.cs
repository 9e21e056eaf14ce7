#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.EditorTools
{
    internal static class SceneSources
    {
        // All sources of the open scenes, and of the prefab that is being edited, including those of inactive objects. It searches all loaded objects,
        // so do not call it for every repaint.
        public static IReadOnlyList<MocapSource> Find() => Resources.FindObjectsOfTypeAll<MocapSource>()
            .Where(OpenScenes.Contains)
            .OrderBy(source => source.name, StringComparer.OrdinalIgnoreCase)
            .ToArray();

        // Objects of one scene cannot refer to those of another one.
        public static MocapSource? FirstIn(Scene scene) => Find().FirstOrDefault(source => source.gameObject.scene == scene);
    }
}
