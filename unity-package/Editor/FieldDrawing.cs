#nullable enable

using System;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace NeuronMocap.Unity.EditorTools
{
    internal static class FieldDrawing
    {
        // Draws all fields of the component in their own order, except hidden ones. after: receives each field that was drawn.
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

        // Unity marks singletons as not editable, also when it reads them from their files. That would disable all fields.
        public static void MakeEditable(Object singleton) => singleton.hideFlags &= ~HideFlags.NotEditable;

        // Whether a bool field is on, or an enum field has a value, for all selected objects.
        public static bool Is(this SerializedObject serialized, string name, bool value) =>
            serialized.FindProperty(name) is { hasMultipleDifferentValues: false } property && property.boolValue == value;

        public static bool Is(this SerializedObject serialized, string name, int index) =>
            serialized.FindProperty(name) is { hasMultipleDifferentValues: false } property && property.enumValueIndex == index;
    }
}
