#nullable enable

using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // Keys that were pressed in this frame, whichever input handling the project uses.
    internal static class KeyPresses
    {
        // Set by the assembly for the package Input System, which a project may lack.
        public static Func<KeyCode, bool>? IsPressedInInputSystem { get; set; }

        public static bool IsPressed(KeyCode key)
        {
            if (key == KeyCode.None)
                return false;
#if ENABLE_LEGACY_INPUT_MANAGER
            if (Input.GetKeyDown(key))
                return true;
#endif
            return IsPressedInInputSystem?.Invoke(key) == true;
        }
    }
}
