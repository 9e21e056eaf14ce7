#nullable enable

using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Keys that were pressed in this frame, with the old Input Manager and with the package Input System. Use it on the main thread.
    /// </summary>
    public static class KeyPresses
    {
        // Set by the assembly for the package Input System, which a project may lack.
        internal static Func<KeyCode, bool>? IsPressedInInputSystem { get; set; }

        /// <summary>Returns whether a key was pressed in this frame. A key that is held counts in its first frame only.</summary>
        /// <param name="key">The key. <see cref="KeyCode.None"/> is never pressed.</param>
        /// <returns>True in the frame in which the key went down.</returns>
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
