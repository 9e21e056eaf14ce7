#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    [CustomEditor(typeof(FigureBuilder))]
    [CanEditMultipleObjects]
    internal sealed class FigureBuilderEditor : ProblemEditor
    {
        public const string Rebuild = "Rebuild";

        protected override (Severity Severity, string Title, string Problem) Describe()
        {
            var builder = (FigureBuilder)target;
            string title = builder.Figure is null ? "No figure yet"
                : builder.Driver.Performer is { } performer ? $"A figure with the sizes of {performer.Name}"
                : "A figure with default sizes";
            return (SeverityOf(builder.Problem), title, builder.Problem);
        }

        // A changed look applies from the next figure on.
        protected override void DrawButtons()
        {
            var builder = (FigureBuilder)target;
            using (new EditorGUI.DisabledScope(!builder.isActiveAndEnabled))
            {
                if (GUILayout.Button(Rebuild))
                    builder.Rebuild();
            }
        }
    }
}
