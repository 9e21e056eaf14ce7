#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The fields of a component whose script is in the project.
    internal sealed class PresentFields : IVendorFields
    {
        private readonly SerializedObject _serialized;

        public PresentFields(MonoBehaviour component) => _serialized = new SerializedObject(component);

        public string? FindText(string name) => _serialized.FindProperty(name)?.stringValue;

        public float? FindNumber(string name)
        {
            if (!(_serialized.FindProperty(name) is { } property))
                return null;

            return property.propertyType switch
            {
                SerializedPropertyType.Boolean => property.boolValue ? 1 : 0,
                SerializedPropertyType.Float => property.floatValue,
                _ => property.intValue,
            };
        }

        public T? FindObject<T>(string name)
            where T : Object => _serialized.FindProperty(name)?.objectReferenceValue as T;
    }
}
