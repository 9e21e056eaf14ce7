#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity
{
    internal static class Disposal
    {
        // Unity allows Destroy only in play mode, and requires it there.
        public static void Destroy(Object? thing)
        {
            if (thing == null)
                return;

            if (Application.isPlaying)
                Object.Destroy(thing);
            else
                Object.DestroyImmediate(thing);
        }
    }
}
