#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // All fields, and the status below them in play mode. For components that need no more.
    internal abstract class ProblemEditor : Editor
    {
        private RepaintTimer? _timer;
        private (Severity Severity, string Title, string Problem) _state;

        public override void OnInspectorGUI()
        {
            DrawFields();
            if (targets.Length > 1 || !Application.isPlaying)
                return;

            if (Event.current.type == EventType.Layout)
                _state = Describe();

            EditorGUILayout.Space();
            ReportGui.Headline(_state.Severity, _state.Title ?? string.Empty);
            ReportGui.Message(_state.Severity, _state.Problem ?? string.Empty);
            DrawButtons();
        }

        // Title: what the component does. Problem: what is wrong, or empty.
        protected abstract (Severity Severity, string Title, string Problem) Describe();

        protected virtual void DrawFields() => DrawDefaultInspector();

        protected virtual void DrawButtons()
        {
        }

        protected static Severity SeverityOf(string problem) => problem.Length > 0 ? Severity.Warning : Severity.Good;

        private void OnEnable() => _timer = new RepaintTimer(() => Application.isPlaying, Repaint);

        private void OnDisable() => _timer?.Dispose();
    }
}
