#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    // A field that a prefab instance changes.
    internal sealed class PrefabChange
    {
        public PrefabChange(string prefab) => Prefab = prefab;

        // GUID of the prefab.
        public string Prefab { get; }

        public string Field { get; set; } = string.Empty;

        public string Value { get; set; } = string.Empty;
    }
}
