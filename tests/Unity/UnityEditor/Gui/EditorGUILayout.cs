using UnityEngine;
using UnityEngine.StandIn;

namespace UnityEditor;

public static class EditorGUILayout
{
    public static void LabelField(string label, params GUILayoutOption[] options) => ImmediateGui.Add("Label", label);

    public static void LabelField(string label, GUIStyle style, params GUILayoutOption[] options) => ImmediateGui.Add("Label", label, color: Of(style));

    public static void LabelField(string label, string label2, params GUILayoutOption[] options) => ImmediateGui.Add("Label", label, label2);

    public static void LabelField(string label, string label2, GUIStyle style, params GUILayoutOption[] options) =>
        ImmediateGui.Add("Label", label, label2, Of(style));

    public static void HelpBox(string message, MessageType type) => ImmediateGui.Add("HelpBox", message, type.ToString());

    public static void HelpBox(string message, MessageType type, bool wide) => HelpBox(message, type);

    public static void Space()
    {
    }

    public static void Space(float width)
    {
    }

    public static bool PropertyField(SerializedProperty property, params GUILayoutOption[] options) =>
        PropertyField(property, new GUIContent(property.displayName, property.tooltip), options);

    public static bool PropertyField(SerializedProperty property, bool includeChildren, params GUILayoutOption[] options) => PropertyField(property, options);

    public static bool PropertyField(SerializedProperty property, GUIContent label, params GUILayoutOption[] options) =>
        PropertyField(property, label, includeChildren: true, options);

    public static bool PropertyField(SerializedProperty property, GUIContent label, bool includeChildren, params GUILayoutOption[] options)
    {
        using var scope = new EditorGUI.DisabledScope(!property.editable);
        ImmediateGui.Add("Property", label.text, property.ShownValue, tooltip: label.tooltip.Length > 0 ? label.tooltip : property.tooltip);
        if (ImmediateGui.TryTake(label.text, out object? value))
            property.SetShown(value);

        return property.isExpanded;
    }

    public static bool Foldout(bool foldout, string content, bool toggleOnLabelClick) => ImmediateGui.Toggle(foldout, content);

    public static bool Foldout(bool foldout, string content) => ImmediateGui.Toggle(foldout, content);

    public static int Popup(GUIContent label, int selectedIndex, GUIContent[] displayedOptions, params GUILayoutOption[] options)
    {
        string shown = selectedIndex >= 0 && selectedIndex < displayedOptions.Length ? displayedOptions[selectedIndex].text : "";
        ImmediateGui.Add("Popup", label.text, shown, tooltip: label.tooltip);
        return ImmediateGui.TryTake(label.text, out object? value) ? Array.FindIndex(displayedOptions, option => option.text == (string)value!) : selectedIndex;
    }

    public static Vector2 BeginScrollView(Vector2 scrollPosition, params GUILayoutOption[] options) => scrollPosition;

    public static void EndScrollView()
    {
    }

    private static Color? Of(GUIStyle style) => style.normal.textColor == Color.black ? null : style.normal.textColor;

    public class HorizontalScope : GUI.Scope
    {
        public HorizontalScope(params GUILayoutOption[] options) => ImmediateGui.BeginRow();

        public HorizontalScope(GUIStyle style, params GUILayoutOption[] options) => ImmediateGui.BeginRow();

        protected override void CloseScope() => ImmediateGui.EndRow();
    }

    public class VerticalScope : GUI.Scope
    {
        public VerticalScope(params GUILayoutOption[] options)
        {
        }

        public VerticalScope(GUIStyle style, params GUILayoutOption[] options)
        {
        }

        protected override void CloseScope()
        {
        }
    }
}
