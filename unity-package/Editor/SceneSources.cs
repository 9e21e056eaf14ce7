#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    internal static class SceneSources
    {
        // All of the open scenes, those of inactive objects included, none of prefabs. A search through everything that is loaded: not for every
        // repaint.
        public static IReadOnlyList<MocapSource> Find() => Resources.FindObjectsOfTypeAll<MocapSource>()
            .Where(source => !EditorUtility.IsPersistent(source) && source.gameObject.scene.IsValid())
            .OrderBy(source => source.name, StringComparer.OrdinalIgnoreCase)
            .ToArray();
    }
}
