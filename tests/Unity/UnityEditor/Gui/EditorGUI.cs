using UnityEngine;

namespace UnityEditor;

public static class EditorGUI
{
    public static int indentLevel { get; set; }

    public static void DrawRect(Rect rect, Color color)
    {
    }

    public readonly struct DisabledScope : IDisposable
    {
        private readonly bool _before;

        public DisabledScope(bool disabled)
        {
            _before = GUI.enabled;
            GUI.enabled &= !disabled;
        }

        public void Dispose() => GUI.enabled = _before;
    }
}
