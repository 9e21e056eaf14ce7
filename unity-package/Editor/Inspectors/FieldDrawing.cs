#nullable enable

using System;
using UnityEditor;

namespace NeuronMocap.Unity.EditorTools
{
    internal static class FieldDrawing
    {
        // All fields of the component in their own order, but those that mean nothing as things are. after: told each that was drawn.
        public static void Draw(SerializedObject serialized, Func<string, bool> isHidden, Action<SerializedProperty>? after = null)
        {
            SerializedProperty property = serialized.GetIterator();
            for (bool entersChildren = true; property.NextVisible(entersChildren); entersChildren = false)
            {
                if (property.name is "m_Script" || isHidden(property.name))
                    continue;

                EditorGUILayout.PropertyField(property, true);
                after?.Invoke(property);
            }
        }

        // A bool field that is on, or an enum field at a value, for all that are selected.
        public static bool Is(this SerializedObject serialized, string name, bool value) =>
            serialized.FindProperty(name) is { hasMultipleDifferentValues: false } property && property.boolValue == value;

        public static bool Is(this SerializedObject serialized, string name, int index) =>
            serialized.FindProperty(name) is { hasMultipleDifferentValues: false } property && property.enumValueIndex == index;
    }
}
