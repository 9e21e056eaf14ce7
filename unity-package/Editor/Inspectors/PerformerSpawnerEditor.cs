#nullable enable

using UnityEditor;

namespace NeuronMocap.Unity.EditorTools
{
    [CustomEditor(typeof(PerformerSpawner))]
    [CanEditMultipleObjects]
    internal sealed class PerformerSpawnerEditor : ProblemEditor
    {
        protected override (Severity Severity, string Title, string Problem) Describe()
        {
            var spawner = (PerformerSpawner)target;
            string title = spawner.Figures.Count == 1 ? "1 figure" : $"{spawner.Figures.Count} figures";
            return (SeverityOf(spawner.Problem), title, spawner.Problem);
        }
    }
}
