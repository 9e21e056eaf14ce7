using UnityEngine.StandIn;

namespace UnityEngine;

public static class GUILayout
{
    private static readonly GUILayoutOption Any = new();

    public static bool Button(string text, params GUILayoutOption[] options) => ImmediateGui.Button("Button", text);

    public static bool Button(string text, GUIStyle style, params GUILayoutOption[] options) => ImmediateGui.Button("Button", text);

    public static bool Button(GUIContent content, params GUILayoutOption[] options) => ImmediateGui.Button("Button", content.text);

    public static bool Button(GUIContent content, GUIStyle style, params GUILayoutOption[] options) => ImmediateGui.Button("Button", content.text);

    public static bool Toggle(bool value, string text, params GUILayoutOption[] options) => ImmediateGui.Toggle(value, text);

    public static bool Toggle(bool value, string text, GUIStyle style, params GUILayoutOption[] options) => ImmediateGui.Toggle(value, text);

    public static bool Toggle(bool value, GUIContent content, GUIStyle style, params GUILayoutOption[] options) => ImmediateGui.Toggle(value, content.text);

    public static void Label(string text, params GUILayoutOption[] options) => ImmediateGui.Add("Label", text);

    public static void Label(string text, GUIStyle style, params GUILayoutOption[] options) => ImmediateGui.Add("Label", text, color: style.normal.textColor);

    public static void Space(float pixels)
    {
    }

    public static void FlexibleSpace()
    {
    }

    public static void BeginHorizontal(params GUILayoutOption[] options) => ImmediateGui.BeginRow();

    public static void EndHorizontal() => ImmediateGui.EndRow();

    public static void BeginArea(Rect screenRect)
    {
    }

    public static void EndArea()
    {
    }

    public static GUILayoutOption Width(float width) => Any;

    public static GUILayoutOption MinWidth(float minWidth) => Any;

    public static GUILayoutOption Height(float height) => Any;

    public static GUILayoutOption MinHeight(float minHeight) => Any;

    public static GUILayoutOption ExpandWidth(bool expand) => Any;

    public static GUILayoutOption ExpandHeight(bool expand) => Any;
}
