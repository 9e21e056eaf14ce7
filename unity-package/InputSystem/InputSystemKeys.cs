#nullable enable

using UnityEngine;
using UnityEngine.InputSystem;

namespace NeuronMocap.Unity.InputSystem
{
    // Reads the keyboard of the Input System for the components, which know the keys of the old Input Manager.
    internal static class InputSystemKeys
    {
        // In the editor also when scripts are compiled in play mode.
#if UNITY_EDITOR
        [UnityEditor.InitializeOnLoadMethod]
#endif
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Register() => KeyPresses.IsPressedInInputSystem = IsPressed;

        private static bool IsPressed(KeyCode code) =>
            Keyboard.current is { } keyboard && KeyOf(code) is var key && key != Key.None && keyboard[key].wasPressedThisFrame;

        // None for keys that the Input System lacks, and for buttons of mice and joysticks.
        internal static Key KeyOf(KeyCode code) => code switch
        {
            >= KeyCode.A and <= KeyCode.Z => Key.A + (code - KeyCode.A),
            KeyCode.Alpha0 => Key.Digit0,
            >= KeyCode.Alpha1 and <= KeyCode.Alpha9 => Key.Digit1 + (code - KeyCode.Alpha1),
            >= KeyCode.Keypad0 and <= KeyCode.Keypad9 => Key.Numpad0 + (code - KeyCode.Keypad0),
            >= KeyCode.F1 and <= KeyCode.F12 => Key.F1 + (code - KeyCode.F1),
            KeyCode.Space => Key.Space,
            KeyCode.Return => Key.Enter,
            KeyCode.Tab => Key.Tab,
            KeyCode.Escape => Key.Escape,
            KeyCode.Backspace => Key.Backspace,
            KeyCode.Delete => Key.Delete,
            KeyCode.Insert => Key.Insert,
            KeyCode.Home => Key.Home,
            KeyCode.End => Key.End,
            KeyCode.PageUp => Key.PageUp,
            KeyCode.PageDown => Key.PageDown,
            KeyCode.UpArrow => Key.UpArrow,
            KeyCode.DownArrow => Key.DownArrow,
            KeyCode.LeftArrow => Key.LeftArrow,
            KeyCode.RightArrow => Key.RightArrow,
            KeyCode.LeftShift => Key.LeftShift,
            KeyCode.RightShift => Key.RightShift,
            KeyCode.LeftControl => Key.LeftCtrl,
            KeyCode.RightControl => Key.RightCtrl,
            KeyCode.LeftAlt => Key.LeftAlt,
            KeyCode.RightAlt => Key.RightAlt,
            KeyCode.CapsLock => Key.CapsLock,
            KeyCode.Numlock => Key.NumLock,
            KeyCode.ScrollLock => Key.ScrollLock,
            KeyCode.Pause => Key.Pause,
            KeyCode.Print => Key.PrintScreen,
            KeyCode.Menu => Key.ContextMenu,
            KeyCode.BackQuote => Key.Backquote,
            KeyCode.Quote => Key.Quote,
            KeyCode.Semicolon => Key.Semicolon,
            KeyCode.Comma => Key.Comma,
            KeyCode.Period => Key.Period,
            KeyCode.Slash => Key.Slash,
            KeyCode.Backslash => Key.Backslash,
            KeyCode.LeftBracket => Key.LeftBracket,
            KeyCode.RightBracket => Key.RightBracket,
            KeyCode.Minus => Key.Minus,
            KeyCode.Equals => Key.Equals,
            KeyCode.KeypadEnter => Key.NumpadEnter,
            KeyCode.KeypadPlus => Key.NumpadPlus,
            KeyCode.KeypadMinus => Key.NumpadMinus,
            KeyCode.KeypadMultiply => Key.NumpadMultiply,
            KeyCode.KeypadDivide => Key.NumpadDivide,
            KeyCode.KeypadPeriod => Key.NumpadPeriod,
            KeyCode.KeypadEquals => Key.NumpadEquals,
            _ => Key.None,
        };
    }
}
