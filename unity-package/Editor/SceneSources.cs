#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.EditorTools
{
    internal static class SceneSources
    {
        // All sources of the open scenes, including those of inactive objects, without those of prefabs. It searches all loaded objects, so do not
        // call it for every repaint.
        public static IReadOnlyList<MocapSource> Find() => Resources.FindObjectsOfTypeAll<MocapSource>()
            .Where(source => !EditorUtility.IsPersistent(source) && source.gameObject.scene.IsValid())
            .OrderBy(source => source.name, StringComparer.OrdinalIgnoreCase)
            .ToArray();

        // Objects of one scene cannot refer to those of another one.
        public static MocapSource? FirstIn(Scene scene) => Find().FirstOrDefault(source => source.gameObject.scene == scene);
    }
}
